#pragma once

#include "meshes/field_history.h"
#include "mpm/body_record.h"
#include "verification/compare/outcomes.h"
#include "verification/scene/scene.h"

#include <string>
#include <vector>

/// What a run says about a body that fails and moves, each a number with a unit.
namespace wetfront::verification {

/// A scene in which a body is followed: events end stages, or markers ride on it.
bool follows_a_body(const Scene& scene);

/// failure_time, slide_duration (5 to 95 % of the way that the farthest rider goes after failure), largest_displacement
/// and largest_velocity of the riders, displacement_p95 over all points, failure_depth (of what had moved when the
/// slope failed, a fifth as far as the farthest point at least) and slide_depth, at the end (parts of the thickness, 1:
/// to the base; above or at 0.5 the slide is deep) and where it lies; arrival, rate of rise and intervals at gauges;
/// the first rise of any gauge against ponding (wetting_order < 0: the base first).
std::vector<Outcome> body_outcomes(const Scene& scene, const meshes::FieldHistory& history,
                                   const mpm::BodyRecord& body);

/// What the number of failure_depth, slide_depth ("deep", "shallow") or wetting_order ("base first", "surface first")
/// means; empty for any other, and for what did not happen.
std::string in_words(const Outcome& outcome);

/// Whether it is an interval that is negative: the same pair of gauges stands there the other way round, too.
bool told_the_other_way(const Outcome& outcome);

}  // namespace wetfront::verification
