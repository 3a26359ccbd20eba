#pragma once

#include "meshes/field_history.h"
#include "mpm/body_record.h"
#include "verification/compare/outcomes.h"
#include "verification/scene/scene.h"

#include <vector>

/// What a run says about a body that fails and moves, each a number with a unit.
namespace wetfront::verification {

/// failure_time, slide_duration (5 to 95 % of the largest displacement of the riders), largest_displacement and
/// largest_velocity of the riders, displacement_p95 over all points, slide_depth (part of the thickness, 1: to the
/// base; above or at 0.5 the slide is deep) and where it lies; arrival, rate of rise and intervals at gauges; the first
/// rise of any gauge against ponding (wetting_order < 0: the base first).
std::vector<Outcome> body_outcomes(const Scene& scene, const meshes::FieldHistory& history,
                                   const mpm::BodyRecord& body);

}  // namespace wetfront::verification
