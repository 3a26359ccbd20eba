#pragma once

#include "mpm/problem.h"
#include "verification/scene/scene.h"

namespace wetfront::verification {

/// A soil of the scene in the MPM's terms: suctions in Pa. Throws std::logic_error without water where laws need rho g.
mpm::Soil mpm_soil(const Scene& scene, const Soil& soil);

}  // namespace wetfront::verification
