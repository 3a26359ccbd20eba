#pragma once

#include "mpm/problem.h"
#include "reports/record.h"
#include "verification/compare/measure.h"
#include "verification/run/run_candidate.h"
#include "verification/run/solve_reference.h"
#include "verification/run/solve_to_accuracy.h"
#include "verification/scene/scene.h"
#include "verification/translate/timeline.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wetfront::verification {

/// Exit codes of every command, in the order of architecture: the worst of several runs counts.
enum class Exit { pass = 0, fail = 1, bad_input = 2, gave_up = 3, inconclusive = 4 };
/// Of a run that reached its end.
Exit exit_for(reports::Verdict verdict);
/// The one that counts when there are several: pass, inconclusive, fail, gave_up, bad_input, the last the worst.
Exit worse(Exit a, Exit b);

/// A scene with everything derived from it that needs no solver.
struct Prepared {
  Scene scene;
  Timeline timeline;
  mpm::Problem<2> problem;
};

/// Meshes the scene and translates it for the material point method. Throws what is wrong with it.
Prepared prepare(const Scene& scene);

inline Solved solve_candidate(const mpm::Problem<2>& problem) {
  return run_candidate(problem);
}

/// Solves, compares and records. `candidate` may differ from what the scene asks for: that is how faults are injected.
struct RunResult {
  reports::Record record;
  Exit exit = Exit::pass;
  Solved candidate;
  std::optional<ReferenceRuns> reference;          ///< absent in a scene that has none
  std::vector<reports::FieldFile> worst_points{};  ///< of fields that fail (present/worst_points.h)
  bool stopped = false;                            ///< Ctrl-C: nothing more is to be run
};
RunResult run_prepared(const Prepared& prepared, const ReferenceStore& store = {}, const Stopping& stopping = {});
/// The same with a candidate that was refined to an accuracy; `prepared.problem` is not solved.
RunResult run_prepared(const Prepared& prepared, const ReferenceStore& store, const AccurateCandidate& candidate);

/// Log lines and CPU seconds of one solver into the record.
void note_solver(reports::Record& record, const std::string& who, const Solved& solved);

/// One sentence per solver that gave up.
std::vector<std::string> why_given_up(const RunResult& result);

struct RunOptions {
  ReferenceStore store{};
  double accuracy = 0;               ///< overrules the scene's; 0: as the scene says
  bool resume = false;               ///< go on from the checkpoint in the folder
  double checkpoint_every = 60;      ///< s of wall time; 0: after every step
  bool ledger = false;               ///< also where the differences come from: runs both solvers several times more
  bool ledger_where_cheap = false;   ///< the same if that is expected to cost little (ledger_of_run.h)
  std::vector<std::string> notes{};  ///< for the log, e.g. why these settings were chosen
};
/// Where a run of the scene in `folder` keeps its state.
CheckpointFile checkpoint_of(const Scene& scene, const std::filesystem::path& folder);
/// Runs a scene and leaves report.html, result.json, CSV, fields and the exact scene in `folder`.
RunResult run_scene(const Scene& scene, const std::filesystem::path& folder, const RunOptions& options);

/// A name for the scene's output folder: the file's stem, or its folder's name for ".../NAME/scene.toml".
std::string case_name(const std::filesystem::path& scene);

}  // namespace wetfront::verification
