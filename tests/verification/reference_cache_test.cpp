// A reference is computed once: what is stored comes back to the bit, and only for the same problem.
#include "verification/run/history_file.h"
#include "verification/run/problem_hash.h"
#include "verification/run/solve_reference.h"
#include "verification/scene/read.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <set>

namespace wetfront::verification {
namespace {

struct ReferenceCache : testing::Test {
  std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "wetfront_references";
  void SetUp() override { std::filesystem::remove_all(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }
};

meshes::FieldHistory small_history() {
  meshes::FieldHistory history;
  history.solver = "fem";
  history.mesh.dim = 1;
  history.mesh.nodes = {{0.1, 0, 0}, {1.0 / 3, 0, 0}};
  history.mesh.cells = {0, 1};
  history.mesh.region = {0};
  history.mesh.region_names = {"sand"};
  history.mesh.sides = {{"top", {1}}};
  history.snapshots = {{.time = 0.1, .stage = "infiltration", .node_pressure = {-1e4, 2.0 / 3}}};
  history.ledger = {{.time = 0.1, .stored = 1.0 / 7}};  // stored_points is NaN
  history.sides = {{"top", "rain", {0.1}, {0}, {0}, {0}, {0}}};
  history.gauges = {{"base", {0.1, 0, 0}, {0.1}, {-5}, {0.4}}};
  history.rain_by_node = {{1, {0.3, 0, 0}, 0.1, 0.1, 0}};
  history.cost = {{"stage", "residual", 0.01, 7}};
  history.counters = {{"steps", 12}};
  history.log = {"a sentence"};
  return history;
}

TEST_F(ReferenceCache, AHistoryComesBackToTheBit) {
  const meshes::FieldHistory history = small_history();
  write_history(history, folder / "a.cbor");
  const auto read = read_history(folder / "a.cbor");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->mesh.nodes, history.mesh.nodes);
  EXPECT_EQ(read->mesh.sides[0].faces, history.mesh.sides[0].faces);
  EXPECT_EQ(read->snapshots[0].node_pressure, history.snapshots[0].node_pressure);
  EXPECT_EQ(read->ledger[0].stored, history.ledger[0].stored);
  EXPECT_TRUE(std::isnan(read->ledger[0].stored_points));
  EXPECT_EQ(read->sides[0].asked, history.sides[0].asked);
  EXPECT_EQ(read->gauges[0].pressure, history.gauges[0].pressure);
  EXPECT_EQ(read->counters, history.counters);
  EXPECT_EQ(read->log, history.log);
}

TEST_F(ReferenceCache, ADamagedFileIsNotBelieved) {
  const auto file = folder / "a.cbor";
  write_history(small_history(), file);
  {
    std::fstream damage(file, std::ios::in | std::ios::out | std::ios::binary);
    damage.seekp(200);
    damage.put('\x7f');
  }
  EXPECT_FALSE(read_history(file));
  std::filesystem::resize_file(file, 100);
  EXPECT_FALSE(read_history(file));
  EXPECT_FALSE(read_history(folder / "none.cbor"));
}

fem_reference::RichardsProblem problem() {
  fem_reference::RichardsProblem problem;
  problem.mesh = small_history().mesh;
  problem.soils = {{"sand", fem_reference::VanGenuchten{0.05, 0.4, 2, 3}, fem_reference::MualemConductivity{}, 1e-4}};
  problem.boundary = {fem_reference::RainSide{"top", {{0}, {1e-5}}}};
  problem.initial_head = {-1, -1};
  problem.end_time = 10;
  return problem;
}

TEST_F(ReferenceCache, EveryChangeOfAProblemChangesItsName) {
  using fem_reference::RichardsProblem;
  const std::vector<std::function<void(RichardsProblem&)>> changes = {
      [](auto& p) { p.soils[0].saturated_conductivity *= 1 + 1e-15; },
      [](auto& p) { std::get<fem_reference::VanGenuchten>(p.soils[0].retention).n = 3.1; },
      [](auto& p) {
        p.soils[0].retention = fem_reference::ExponentialRetention{0.05, 0.4, 2};
      },
      [](auto& p) { p.soils[0].oedometer_modulus = 1e7; },
      [](auto& p) { p.boundary = {fem_reference::FreeDrainageSide{"top"}}; },
      [](auto& p) { std::get<fem_reference::RainSide>(p.boundary[0]).rain.intensity[0] = 2e-5; },
      [](auto& p) { p.initial_head[1] = -1.1; },
      [](auto& p) { p.mesh.nodes[1][0] = 0.4; },
      [](auto& p) { p.mesh.sides[0].name = "base"; },
      [](auto& p) { p.conductivity_factor = {2}; },
      [](auto& p) { p.adaptivity.emplace(); },
      [](auto& p) { p.output_times = {5}; },
      [](auto& p) { p.integrator = fem_reference::Integrator::backward_euler; },
      [](auto& p) { p.degree = 2; },
  };
  std::set<std::string> names{*problem_hash(problem())};
  EXPECT_EQ(names.count(*problem_hash(problem())), 1u);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    auto changed = problem();
    changes[i](changed);
    EXPECT_TRUE(names.insert(*problem_hash(changed)).second) << "change " << i;
  }
}

TEST_F(ReferenceCache, AProblemWithAFunctionHasNoName) {
  auto with_source = problem();
  with_source.source = [](const meshes::Point&, double) { return 0.0; };
  EXPECT_FALSE(problem_hash(with_source));
}

TEST_F(ReferenceCache, TheSecondRunTakesWhatTheFirstComputed) {
  Scene scene = read_scene(std::filesystem::path(WETFRONT_SOURCE_DIR) /
                           "verification/cases/seed_column/scene_1.5e-4_smin0.87.toml");
  scene.reference->cells = 40;
  const ReferenceStore store{folder};
  const Timeline times = timeline(scene);
  const Solved first = solve_reference(scene, times, store), second = solve_reference(scene, times, store);
  EXPECT_TRUE(first.taken_from.empty());
  EXPECT_FALSE(second.taken_from.empty());
  EXPECT_EQ(first.history.snapshots.back().node_pressure, second.history.snapshots.back().node_pressure);
  scene.soils[0].intrinsic_permeability *= 1.01;
  EXPECT_TRUE(solve_reference(scene, times, store).taken_from.empty());
}

}  // namespace
}  // namespace wetfront::verification
