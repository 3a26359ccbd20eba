#include "verification/run/solve_reference.h"

#include "fem_reference/richards_problem.h"
#include "verification/run/history_file.h"
#include "verification/run/problem_hash.h"
#include "verification/run/progress.h"
#include "verification/translate/scene_mesh.h"
#include "verification/translate/to_reference.h"

#include <utility>

namespace wetfront::verification {
namespace {

Solved solve(const fem_reference::RichardsProblem& problem, const std::string& name, const ReferenceStore& store) {
  const auto hash = store.folder.empty() ? std::nullopt : problem_hash(problem);
  const std::filesystem::path file = hash ? store.folder / (*hash + ".cbor") : std::filesystem::path();
  if (hash) {
    if (auto kept = read_history(file)) return {std::move(*kept), "", file.string()};
  }
  const ProgressLine line(name);
  try {
    Solved solved{fem_reference::solve(problem, show_progress), "", ""};
    if (hash) write_history(solved.history, file);
    return solved;
  } catch (const fem_reference::GaveUp& error) {
    return {error.partial, error.what(), ""};  // not kept: what failed may be cured by the next version
  }
}

}  // namespace

std::vector<std::pair<std::string, const Solved*>> ReferenceRuns::all() const {
  std::vector<std::pair<std::string, const Solved*>> runs{{"reference", &reference}};
  if (coarser) runs.emplace_back("reference, cells twice as large", &*coarser);
  runs.emplace_back("reference, cells half as large", &finer);
  runs.emplace_back("reference, a tenth of the tolerance", &tighter);
  return runs;
}

Solved solve_reference(const Scene& scene, const Timeline& timeline, const ReferenceStore& store) {
  const Resolution resolution{scene.reference->cells, 0, scene.reference->tolerance};
  return solve(to_reference(scene, timeline, resolution), "reference", store);
}

ReferenceRuns solve_references(const Scene& scene, const Timeline& timeline, const ReferenceStore& store) {
  const ReferenceSettings& settings = *scene.reference;
  const auto on = [&](int halvings, double tolerance, const std::string& name) {
    return solve(to_reference(scene, timeline, {settings.cells, halvings, tolerance}), name, store);
  };
  ReferenceRuns runs;
  runs.reference = solve_reference(scene, timeline, store);
  runs.finer = on(1, settings.tolerance, "reference, cells half as large");
  runs.tighter = on(0, settings.tolerance / 10, "reference, a tenth of the tolerance");
  if (can_coarsen(scene, settings.cells)) runs.coarser = on(-1, settings.tolerance, "reference, cells twice as large");
  return runs;
}

Histories histories_of(meshes::FieldHistory candidate, const ReferenceRuns& reference) {
  Histories histories{
      std::move(candidate), reference.reference.history, {}, reference.finer.history, reference.tighter.history};
  if (reference.coarser) histories.coarser = reference.coarser->history;
  return histories;
}

}  // namespace wetfront::verification
