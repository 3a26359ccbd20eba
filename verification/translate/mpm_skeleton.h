#pragma once

#include "mpm/problem.h"
#include "verification/scene/scene.h"

namespace wetfront::verification {

/// What the skeleton meets on sides: fixities, loads and the rest.
void add_skeleton_sides(const Scene& scene, mpm::Problem<2>& problem);

mpm::SkeletonScheme skeleton_scheme_of(const SkeletonSettings& settings);

}  // namespace wetfront::verification
