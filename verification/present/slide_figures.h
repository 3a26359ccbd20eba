#pragma once

#include "mpm/body_record.h"
#include "reports/record.h"
#include "verification/compare/body_outcomes.h"
#include "verification/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace wetfront::verification {

/// The body at failure and at rest, its outline through the slide, the markers' displacement and velocity. Empty where
/// no event ended a stage and nothing was followed.
std::vector<reports::Figure> slide_figures(const Scene& scene, const meshes::FieldHistory& history,
                                           const mpm::BodyRecord& body);

/// Stages as they went, with what each plan held.
reports::Table stage_table(const mpm::BodyRecord& body);
/// What came out of the same scene on cells of another size.
struct OnSecondMesh {
  std::string cells;  ///< the header over it
  std::vector<Outcome> outcomes;
};
/// All of body_outcomes(), beside those of the second mesh where there is one.
reports::Table outcome_table(const std::vector<Outcome>& outcomes, const std::optional<OnSecondMesh>& second);
/// What the scene says is known ([[observed]]) beside what came out here.
reports::Table observed_table(const Scene& scene, const std::vector<Outcome>& outcomes,
                              const std::optional<OnSecondMesh>& second);

}  // namespace wetfront::verification
