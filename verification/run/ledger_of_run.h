#pragma once

#include "verification/run/run_scene.h"

namespace wetfront::verification {

/// What the probes of a ledger may be expected to take [CPU s] for it to be made unasked.
inline constexpr double cheap_ledger = 5;

/// Before anything is run: throws SceneError where a ledger is asked for and the scene has nothing to explain.
void check_ledger(const Scene& scene, const Timeline& timeline);

/// Where the differences come from, into the record; its verdicts count as the others do.
void add_difference_ledger(const Scene& scene, const Timeline& timeline, const ReferenceStore& store,
                           RunResult& result);

/// The same where its probes are expected to cost no more than `cheap_ledger`, by what the run itself has cost; else a
/// line on the page that says what to call. Nothing where there is nothing to explain.
void add_ledger_where_cheap(const Scene& scene, const Timeline& timeline, const ReferenceStore& store,
                            RunResult& result);

/// What the probes are expected to take [CPU s].
double expected_ledger_cpu(const Scene& scene, const RunResult& result);

}  // namespace wetfront::verification
