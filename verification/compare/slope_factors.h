#pragma once

#include "meshes/field_history.h"
#include "verification/scene/scene.h"

#include <optional>

namespace wetfront::verification {

/// Factors of safety of the infinite slope through the middle of the steepest part of the surface, each the least over
/// depth, from the pressures and saturations of a run (exact/infinite_slope.h; verification's own weights and
/// strength).
struct SlopeFactors {
  double place = 0, angle = 0;               ///< m along x; rad
  double limit = 0, davis = 0, reduced = 0;  ///< with tan phi'; Davis' strength; as strength reduction takes it
  double limit_depth = 0, davis_depth = 0;   ///< vertical, of the least ones [m]
};

/// Nothing where the ground is no slope or profile or has zones, or where a soil has no friction and cohesion. `mesh`
/// is that of the snapshot, in which the body has not moved far.
std::optional<SlopeFactors> slope_factors(const Scene& scene, const meshes::Mesh& mesh,
                                          const meshes::Snapshot& snapshot);

}  // namespace wetfront::verification
