#pragma once

#include "fem_reference/richards_problem.h"
#include "verification/scene/scene.h"

#include <vector>

namespace wetfront::verification {

/// What the scene says of the sides, as the reference sees it: rain, evaporation and a water level on one side become
/// one condition.
std::vector<fem_reference::BoundaryCondition> reference_sides(const Scene& scene, double unit_weight);

/// The same sides before the run starts: `rain` where it rains and, elsewhere, for ever what holds at t = 0.
/// Evaporation goes on as at t = 0 where `evaporating`, else there is none.
std::vector<fem_reference::BoundaryCondition> antecedent_sides(const Scene& scene, double unit_weight,
                                                               const meshes::RainRecord& rain, bool evaporating);

}  // namespace wetfront::verification
