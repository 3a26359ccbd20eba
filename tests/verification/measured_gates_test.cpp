// Gates that only case scenes have: what a published simulation says at probes, and pressure against the reference on
// one mesh and on a finer one. Histories by hand, from measurement to verdict.
#include "meshes/gmsh.h"
#include "tests/meshes/shapes.h"
#include "verification/compare/measure.h"
#include "verification/compare/verdict.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace wetfront::verification {
namespace {

using reports::Verdict;

/// A metre of ground over a water table at its foot, water of 10 kN/m3: the initial pressure ranges over 10 kPa.
Scene ground() {
  Scene scene;
  scene.gravity = {0, -10, 0};
  scene.water = Water{};
  scene.geometry.shape = Box{{0.2, 1}, {1, 5}};
  scene.initial = InitialState{HydrostaticStart{0, INFINITY}, {}};
  scene.comparison.times = {{100, false, {}}};
  return scene;
}

Timeline until_a_thousand() {
  Timeline timeline;
  timeline.stage_end = {1000};
  timeline.comparison_times = {100};
  return timeline;
}

/// The same pressure at a time all over a strip of so many cells; no water goes in or out.
meshes::FieldHistory strip(int cells, double pressure) {
  meshes::FieldHistory history;
  history.mesh = meshes::generate(meshes::strip_script(1.0, 0.2, cells), 2);
  meshes::Snapshot snapshot;
  snapshot.time = 100;
  snapshot.node_pressure.assign(history.mesh.node_count(), pressure);
  snapshot.node_saturation.assign(history.mesh.node_count(), 0.5);
  snapshot.cell_pressure.assign(history.mesh.cell_count(), pressure);
  snapshot.cell_saturation.assign(history.mesh.cell_count(), 0.5);
  history.snapshots = {snapshot};
  meshes::LedgerRow row;
  row.stored = 1;
  for (row.time = 0; row.time <= 1000; row.time += 1000) history.ledger.push_back(row);
  return history;
}

/// A gauge that rises by 20 Pa/s, which is 2 mm of head per second, so that it passes 0.2 kPa at `arrival`.
meshes::Gauge rising(const std::string& name, double arrival) {
  meshes::Gauge gauge;
  gauge.name = name;
  for (double t = 0; t <= 1000; t += 10) {
    gauge.time.push_back(t);
    gauge.pressure.push_back(200 + 20 * (t - arrival));
  }
  return gauge;
}

Histories all_alike(double candidate, double reference, double finer) {
  Histories histories{strip(5, candidate), strip(5, reference), {}, strip(10, finer), strip(5, reference)};
  histories.candidate.gauges = {rising("A", 95), rising("B", 300)};
  return histories;
}

/// What the one gate of the scene comes to; "no gate" is Verdict::info.
reports::Finding judged(Scene scene, const std::string& quantity, double tolerance, const Histories& histories,
                        const std::string& probe = "") {
  scene.comparison.tolerances = {{quantity, {}, probe, tolerance, "by hand", {}}};
  Timeline timeline = until_a_thousand();
  timeline.tolerance_times = {std::nan("")};
  for (const auto& finding : judge(scene, timeline, measure(scene, timeline, histories), 0))
    if (finding.quantity == quantity && finding.verdict != Verdict::info) return finding;
  return {};
}

struct Published {
  const char *quantity, *observed, *printed;
  double off;  ///< of what comes out here, relative
};

/// Here A rises at 95 s, B 205 s later, both by 2 mm/s.
class PublishedGates : public testing::TestWithParam<Published> {};

TEST_P(PublishedGates, PassWithinTheirToleranceAndFailBeyondIt) {
  Scene scene = ground();
  scene.observations = {{GetParam().observed, "1 s", GetParam().printed, "", {}}};
  const Histories histories = all_alike(-1000, -1000, -1000);
  const auto within = judged(scene, GetParam().quantity, 1.01 * GetParam().off, histories, "A");
  const auto beyond = judged(scene, GetParam().quantity, 0.99 * GetParam().off, histories, "A");
  EXPECT_EQ(within.verdict, Verdict::pass) << within.error;
  EXPECT_EQ(beyond.verdict, Verdict::fail) << beyond.error;
  EXPECT_NEAR(beyond.error, GetParam().off, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All, PublishedGates,
                         testing::Values(Published{"published_arrival_time", "arrival_time:A", "about 100 s", 0.05},
                                         Published{"published_arrival_time", "arrival_time:A", "19 to 50 s", 0.9},
                                         Published{"published_rise_rate", "rise_rate:A", "2.5e-3 m/s", 0.2},
                                         Published{"published_interval", "interval:A:B", "about 200 s", 0.025}));

TEST(PublishedGates, WhatDidNotRiseFailsAndWhatIsNotPrintedIsOpen) {
  Scene scene = ground();
  scene.observations = {{"arrival_time:A", "", "100 s", "", {}}, {"rise_rate:A", "2e-3 m/s", "", "", {}}};
  Histories histories = all_alike(-1000, -1000, -1000);
  EXPECT_EQ(judged(scene, "published_rise_rate", 1, histories).verdict, Verdict::inconclusive) << "measured alone";
  for (double& pressure : histories.candidate.gauges[0].pressure) pressure = -1000;
  EXPECT_EQ(judged(scene, "published_arrival_time", 1, histories).verdict, Verdict::fail);
}

/// 300 Pa of 10 kPa off the reference, 500 Pa off its finer mesh.
TEST(PressureGates, OneMeshAndAFinerOneAreEachHeldAgainstTheirOwnReference) {
  const Histories histories = all_alike(-1300, -1000, -800);
  for (const auto& [quantity, off] : {std::pair{"pressure_one_mesh", 0.03}, {"pressure_finer", 0.05}}) {
    const auto within = judged(ground(), quantity, 1.01 * off, histories);
    EXPECT_EQ(within.verdict, Verdict::pass) << quantity << ' ' << within.error;
    EXPECT_EQ(within.reference_bound, 0) << quantity;
    const auto beyond = judged(ground(), quantity, 0.99 * off, histories);
    EXPECT_EQ(beyond.verdict, Verdict::fail) << quantity << ' ' << beyond.error;
  }
}

TEST(PressureGates, OneMeshIsNotToldOfTwo) {
  Histories histories = all_alike(-1000, -1000, -1000);
  histories.reference = histories.tighter = strip(10, -1000);
  EXPECT_EQ(judged(ground(), "pressure_one_mesh", 0.5, histories).verdict, Verdict::inconclusive);
  EXPECT_EQ(judged(ground(), "pressure_finer", 0.5, histories).verdict, Verdict::pass);
}

}  // namespace
}  // namespace wetfront::verification
