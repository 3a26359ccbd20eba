#include "verification/run/on_second_mesh.h"

#include "verification/compare/body_outcomes.h"
#include "verification/run/finer_cells.h"

#include <exception>
#include <string>

namespace wetfront::verification {

std::optional<OnSecondMesh> on_second_mesh(const Prepared& prepared, RunResult& result) {
  const double factor = prepared.scene.comparison.second_mesh;
  if (factor == 1 || !result.candidate.gave_up.empty()) return {};
  const std::string cells = factor > 1 ? "on half the cell size" : "on twice the cell size", who = "MPM " + cells;
  try {
    const Prepared second = prepare(with_finer_cells(prepared.scene, factor));
    const Solved solved = run_candidate(second.problem);
    note_solver(result.record, who, solved);
    result.stopped = solved.stopped;
    if (!solved.gave_up.empty()) return {};
    return OnSecondMesh{cells, body_outcomes(second.scene, solved.history, solved.body)};
  } catch (const std::exception& problem) {
    result.record.log.push_back(who + ": not run: " + problem.what());
    return {};
  }
}

}  // namespace wetfront::verification
