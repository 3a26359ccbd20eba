#pragma once

#include "fem_reference/richards_problem.h"
#include "verification/scene/scene.h"

namespace wetfront::verification {

/// A soil as the reference sees it: heads for pressures, water contents for saturations, conductivity for permeability.
/// The numbers change, the soil does not. `dim` is that of the mesh.
fem_reference::Soil reference_soil(const Scene& scene, const Soil& soil, int dim);

}  // namespace wetfront::verification
