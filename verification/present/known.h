#pragma once

#include "reports/record.h"
#include "verification/compare/outcomes.h"
#include "verification/scene/scene.h"

#include <string>

/// What the scene says is known from an experiment or a published simulation ([[observed]]), in figures and in words.
namespace wetfront::verification {

/// Into a figure of pressure [kPa] at probes over time: at each probe a line from its first rise (where that is not
/// known, from the one in the candidate) that climbs as fast as was measured and as was simulated; a vertical line at
/// the time of failure that was measured.
void draw_known_rises(reports::Figure& figure, const Scene& scene, const meshes::FieldHistory& candidate);

/// Into a figure of displacement [m]: a level line each from where to where the body went.
void draw_known_displacement(reports::Figure& figure, const Scene& scene);

/// By how much two meshes differ: "0.217 m, 70 %" of the first; "-" where one of them has no number.
std::string difference_of_meshes(const Outcome* here, const Outcome* second);

/// "here 9.8 times less than measured, 14 times less than published; the two meshes differ by 70 %": what came out
/// against what is known, from the nearer end of it. Empty without any number to tell.
std::string in_a_sentence(const Observation& known, const Outcome* here, const Outcome* second);

}  // namespace wetfront::verification
