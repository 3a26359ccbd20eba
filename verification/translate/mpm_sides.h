#pragma once

#include "mpm/problem.h"
#include "verification/scene/scene.h"

#include <vector>

namespace wetfront::verification {

/// What the scene says of the water at its sides, in the MPM's terms. Where the body's surface lies inside cells the
/// side "top" is its free surface.
std::vector<mpm::WaterBoundary> mpm_sides(const Scene& scene);

}  // namespace wetfront::verification
