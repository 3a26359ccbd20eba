#pragma once

#include "mpm/coupling/strength_reduction.h"
#include "verification/run/run_scene.h"

#include <filesystem>
#include <vector>

/// The factor of safety of a slope over time, while it goes from equilibrium to equilibrium.
namespace wetfront::verification {

/// One state and its factor by strength reduction.
struct StateSafety {
  meshes::Snapshot snapshot;
  mpm::SafetyFactor factor;
};
struct SafetyHistory {
  std::vector<StateSafety> states;  ///< in order; the last is the last equilibrium where the slope fails
  Solved run;
};

/// Runs the scene's quasi-static stages (the first ones; of those in true time nothing is needed) and asks for the
/// factor at each time [s, ascending; empty: ten even parts of those stages] and at the last equilibrium of a stage
/// that fails. A run that gives up keeps what it has. Throws SceneError where the scene begins with no such stage or a
/// time lies after them, CannotPlan where a soil has no strength that can be divided.
SafetyHistory safety_history(const Prepared& prepared, std::vector<double> times, const mpm::SafetySearch& search);

/// Factors of safety with the infinite slope beside them (compare/slope_factors.h), stages, cost.
reports::Record safety_page(const Prepared& prepared, const SafetyHistory& history);

}  // namespace wetfront::verification
