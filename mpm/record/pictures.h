#pragma once

#include "mpm/plan/stage_plan.h"

namespace wetfront::mpm {

/// Points and fields as the plan's effects write them, now.
template <int dim>
meshes::Snapshot snapshot_of(const StagePlan<dim>& plan, double time);

/// The same with how far the points have come, where they remember where they began; `of`: see Picture.
template <int dim>
Picture picture_of(const StagePlan<dim>& plan, double time, const std::string& of);

}  // namespace wetfront::mpm
