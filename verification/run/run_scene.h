#pragma once

#include "fem_reference/richards_problem.h"
#include "mpm/problem.h"
#include "reports/record.h"
#include "verification/compare/histories.h"
#include "verification/compare/measure.h"
#include "verification/scene/scene.h"
#include "verification/translate/timeline.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wetfront::verification {

/// Exit codes of every command, in the order of architecture: the worst of several runs counts.
enum class Exit { pass = 0, fail = 1, bad_input = 2, gave_up = 3, inconclusive = 4 };

/// A scene with everything derived from it that needs no solver.
struct Prepared {
  Scene scene;
  Timeline timeline;
  mpm::Problem<2> problem;  ///< empty where only the reference is wanted
};

/// Without the material point method, which knows less than the reference does.
Prepared prepare_reference(const Scene& scene);

/// Meshes the scene and translates it for the material point method. Throws what is wrong with it.
Prepared prepare(const Scene& scene);

/// A solver's result and, if it gave up, why.
struct Solved {
  meshes::FieldHistory history;
  std::string gave_up;  ///< empty: it reached the end
};

/// The reference at the scene's resolution, or on twice the cells with a tenth of the tolerance (`finer`).
Solved solve_reference(const Prepared& prepared, bool finer);
Solved solve_candidate(const mpm::Problem<2>& problem);

/// Solves, compares and records. `candidate` may differ from what the scene asks for: that is how faults are injected.
struct RunResult {
  reports::Record record;
  Exit exit = Exit::pass;
  Solved candidate, reference, finer;
};
RunResult run_prepared(const Prepared& prepared);

/// Runs a scene and leaves report.html, result.json, CSV, fields and the exact scene in `folder`.
RunResult run_scene(const Scene& scene, const std::filesystem::path& folder);

/// A name for the scene's output folder: the file's stem, or its folder's name for ".../NAME/scene.toml".
std::string case_name(const std::filesystem::path& scene);

}  // namespace wetfront::verification
