#pragma once

#include "meshes/field_history.h"
#include "mpm/body_record.h"
#include "verification/scene/scene.h"

#include <string>
#include <vector>

/// What a run says about a body that fails and moves, each a number with a unit.
namespace wetfront::verification {

struct BodyOutcome {
  std::string name;  ///< stable: "failure_time", "largest_displacement", "arrival_time:G-9"
  std::string description;
  std::string unit;
  double value;  ///< NaN: did not happen
};

/// failure_time, slide_duration (5 to 95 % of the largest displacement of the riders), largest_displacement and
/// largest_velocity of the riders, displacement_p95 over all points, slide_depth (part of the thickness, 1: to the
/// base; above or at 0.5 the slide is deep) and where it lies; arrival, rate of rise and intervals at gauges; the first
/// rise of any gauge against ponding (wetting_order < 0: the base first).
std::vector<BodyOutcome> body_outcomes(const Scene& scene, const meshes::FieldHistory& history,
                                       const mpm::BodyRecord& body);

/// The value of one; NaN where there is none of that name.
double value_of(const std::vector<BodyOutcome>& outcomes, const std::string& name);

}  // namespace wetfront::verification
