#pragma once

#include "meshes/field_history.h"
#include "verification/scene/scene.h"
#include "verification/translate/timeline.h"

#include <string>
#include <vector>

/// What a run says about the ground: the quantities that studies follow, each a number with a unit.
namespace wetfront::verification {

struct Outcome {
  std::string name;         ///< stable: "front_position@2", "arrival_time:base", "failure_time"
  std::string description;  ///< with time or probe
  std::string unit;
  double value;  ///< NaN: did not happen
};

/// The one of that name; nullptr where there is none.
const Outcome* find_outcome(const std::vector<Outcome>& outcomes, const std::string& name);
/// Its value; NaN where there is none.
double value_of(const std::vector<Outcome>& outcomes, const std::string& name);

/// Read from any solution by the same rule: fields in the cells of `cells_of`, the candidate. Water is told per
/// horizontal area under rain, or of the ground where none falls. Every solution of a scene has the same outcomes in
/// the same order.
std::vector<Outcome> outcomes(const Scene& scene, const Timeline& timeline, const meshes::FieldHistory& history,
                              const meshes::FieldHistory& cells_of);

/// Elevation of the wetting front at each snapshot [m]; empty where the ground is no column.
std::vector<double> fronts(const Scene& scene, const meshes::FieldHistory& history,
                           const meshes::FieldHistory& cells_of);

}  // namespace wetfront::verification
