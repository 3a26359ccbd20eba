#pragma once

#include "mpm/plan/stage_plan.h"

namespace wetfront::mpm {

/// No equilibrium was found by the criterion of the stage (FailureCriterion). Simulation tries a shorter step, and
/// believes it at the shortest.
struct SkeletonFailed : StepFailed {
  using StepFailed::StepFailed;
};

}  // namespace wetfront::mpm
