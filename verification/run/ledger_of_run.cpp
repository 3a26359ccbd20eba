#include "verification/run/ledger_of_run.h"

#include "verification/compare/verdict.h"
#include "verification/ledger/difference_ledger.h"
#include "verification/ledger/rerun_scene.h"
#include "verification/scene/read.h"

#include <fmt/format.h>

#include <algorithm>

namespace wetfront::verification {

void check_ledger(const Scene& scene, const Timeline& timeline) {
  if (!scene.reference)
    throw SceneError({scene.path.string() +
                      ":1:1: a ledger of differences is asked for, but the scene has no reference "
                      "(there is nothing to differ from). Add [reference]."});
  if (timeline.comparison_times.empty())
    throw SceneError({scene.comparison.origin.text() +
                      ": a ledger of differences is asked for, but no time at which fields are compared (there is "
                      "nothing to explain). Add times to [comparison]."});
}

void add_difference_ledger(const Scene& scene, const Timeline& timeline, const ReferenceStore& store,
                           RunResult& result) {
  if (result.exit == Exit::gave_up) {
    result.record.log.push_back("ledger: not made, as a solver gave up");
    return;
  }
  add_ledger(result.record, difference_ledger({scene, timeline, result.candidate.history, *result.reference,
                                               rerun_scene(scene, timeline), store}));
  result.record.verdict = overall(result.record.findings);
  result.exit = exit_for(result.record.verdict);
}

double expected_ledger_cpu(const Scene& scene, const RunResult& result) {
  // Cells half as large: eight times in the plane as in probes.cpp; columns have twice as many and were seen to take
  // two to four times as long; where the water's waves limit the step, 20 to 30 times (window_3e-5_smin0.87). Steps:
  // four times. The reference runs again under the flux and with each law in tables.
  const bool limited = std::ranges::any_of(scene.stages, [](const Stage& stage) {
    return stage.scheme && *stage.scheme != Scheme::seepage && *stage.scheme != Scheme::semi_implicit;
  });
  const double finer = limited ? 30 : std::holds_alternative<Column>(scene.geometry.shape) ? 4 : 8, steps = 4;
  constexpr double of_the_reference = 6;
  return result.candidate.history.cpu_seconds * (finer + finer * finer + steps + steps * steps + 1) +
         result.reference->reference.history.cpu_seconds * of_the_reference;
}

void add_ledger_where_cheap(const Scene& scene, const Timeline& timeline, const ReferenceStore& store,
                            RunResult& result) {
  if (result.exit == Exit::gave_up || !result.reference || timeline.comparison_times.empty() ||
      result.candidate.history.snapshots.empty() || result.reference->reference.history.snapshots.empty())
    return;
  const double expected = expected_ledger_cpu(scene, result);
  if (expected <= cheap_ledger) {
    add_difference_ledger(scene, timeline, store, result);
    return;
  }
  result.record.tables.push_back(
      {"Where the differences come from: not asked.",
       "Difference ledger",
       fmt::format("Its probes would take about {:.2g} CPU-s, more than the {:g} that are spent unasked. "
                   "To see it: wetfront study difference {}",
                   expected, cheap_ledger, scene.path.string()),
       {},
       {}});
}

}  // namespace wetfront::verification
