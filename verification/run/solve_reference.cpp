#include "verification/run/solve_reference.h"

#include "verification/run/solve_richards.h"
#include "verification/translate/scene_mesh.h"
#include "verification/translate/to_reference.h"

#include <utility>

namespace wetfront::verification {

std::vector<std::pair<std::string, const Solved*>> ReferenceRuns::all() const {
  std::vector<std::pair<std::string, const Solved*>> runs{{"reference", &reference}};
  if (coarser) runs.emplace_back("reference, cells twice as large", &*coarser);
  runs.emplace_back("reference, cells half as large", &finer);
  runs.emplace_back("reference, a tenth of the tolerance", &tighter);
  return runs;
}

Solved solve_reference(const Scene& scene, const Timeline& timeline, const ReferenceStore& store) {
  const Resolution resolution{scene.reference->cells, 0, scene.reference->tolerance};
  return solve_richards(to_reference(scene, timeline, resolution), "reference", store);
}

ReferenceRuns solve_references(const Scene& scene, const Timeline& timeline, const ReferenceStore& store) {
  const ReferenceSettings& settings = *scene.reference;
  const auto on = [&](int halvings, double tolerance, const std::string& name) {
    return solve_richards(to_reference(scene, timeline, {settings.cells, halvings, tolerance}), name, store);
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
