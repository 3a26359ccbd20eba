#pragma once

#include "verification/compare/measure.h"

namespace wetfront::verification {

/// What the run itself must hold where the reference knows nothing: water after failure (infinite time: none), energy
/// and momentum of a skeleton that moves dynamically. `whole` is the candidate's history up to its end.
std::vector<Measurement> measure_motion(const meshes::FieldHistory& whole, double failure);

/// Drift of energy is a share of what has changed hands at most [J], drift of momentum of the largest of momentum and
/// impulses [N s]; both > 0.
double energy_scale(const meshes::FieldHistory& history);
double momentum_scale(const meshes::FieldHistory& history);

}  // namespace wetfront::verification
