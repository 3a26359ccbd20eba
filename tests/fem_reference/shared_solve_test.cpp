// Run by mpirun: rank 0 runs the tests, the others serve its solves.
#include "fem_reference/ranks/shared_solve.h"
#include "columns.h"
#include "fem_reference/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wetfront::fem_reference {
namespace {

using namespace testing;

double worst_difference(const meshes::FieldHistory& a, const meshes::FieldHistory& b) {
  double worst = 0;
  EXPECT_EQ(a.snapshots.size(), b.snapshots.size());
  for (std::size_t s = 0; s < a.snapshots.size(); ++s) {
    const auto &p = a.snapshots[s].node_pressure, &q = b.snapshots[s].node_pressure;
    EXPECT_EQ(p.size(), q.size());
    for (std::size_t i = 0; i < p.size(); ++i) worst = std::max(worst, std::abs(p[i] - q[i]) / unit_weight);
  }
  return worst;
}

/// Rain that ponds on a strip with a water level on its left, free drainage to the right and a gauge in the middle.
RichardsProblem strip() {
  RichardsProblem problem;
  problem.mesh = strip_mesh(12, 1.2, 8);
  problem.gravity_direction = {0, -1, 0};
  problem.unit_weight = unit_weight;
  problem.soils = {seed_sand(0.087)};
  problem.boundary = {RainSide{"top", {{0, 600}, {4e-4, 1e-4}}},
                      WaterLevelSide{"left", {{0, 1000, 2000}, {0.15, 0.55, 0.2}}}, FreeDrainageSide{"right"}};
  for (const meshes::Point& node : problem.mesh.nodes) {
    problem.initial_head.push_back(std::max(-node[1], -10e3 / unit_weight));
  }
  problem.gauges = {{"middle", {0.47, 0.61, 0}}};
  problem.end_time = 1000;
  problem.output_times = {500, 1000};
  problem.tolerance = 1e-4;
  return problem;
}

/// 5 x 5 x 5 cells, rain on one half of the top, a seepage face on the base's side.
RichardsProblem block() {
  constexpr int n = 5, row = n + 1;
  RichardsProblem problem;
  meshes::Mesh& mesh = problem.mesh;
  mesh.dim = 3;
  mesh.region_names = {"sand"};
  mesh.region.assign(n * n * n, 0);
  mesh.sides = {{"wet", {}}, {"left", {}}};
  const auto node = [](int i, int j, int k) { return (k * row + j) * row + i; };
  for (int i = 0; i < row * row * row; ++i) {
    mesh.nodes.push_back({1.0 * (i % row) / n, 1.0 * (i / row % row) / n, 1.2 * (i / row / row) / n});
  }
  constexpr int turn[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int c = 0; c < n * n * n; ++c) {
    const int i = c % n, j = c / n % n, k = c / n / n;
    for (int z : {0, 1}) {
      for (auto [a, b] : turn) mesh.cells.push_back(node(i + a, j + b, k + z));
    }
    for (auto [a, b] : turn) {
      if (k == n - 1 && 2 * i < n) mesh.sides[0].faces.push_back(node(i + a, j + b, n));
      if (i == 0) mesh.sides[1].faces.push_back(node(0, j + a, k + b));
    }
  }
  problem.gravity_direction = {0, 0, -1};
  problem.unit_weight = unit_weight;
  problem.soils = {seed_sand(0.087)};
  problem.boundary = {RainSide{"wet", {{0}, {2e-4}}}, RainSide{"left", {}}};
  for (const meshes::Point& at : mesh.nodes) problem.initial_head.push_back(std::max(-at[2], -0.9));
  problem.end_time = 1500;
  problem.output_times = {500, 1500};
  problem.tolerance = 1e-4;
  return problem;
}

// Inner iterations, other sums and with them other steps: ten times the tolerance [m] is what two runs may differ by.
void agrees(const RichardsProblem& problem) {
  const meshes::FieldHistory one = march_alone(problem, nullptr), all = solve(problem);
  ASSERT_EQ(all.counters.at("ranks"), 2);
  EXPECT_EQ(all.counters.at("degrees of freedom"), one.counters.at("degrees of freedom"));
  EXPECT_LE(worst_difference(one, all), 10 * problem.tolerance);
  EXPECT_LE(worst_imbalance(one), 1e-8);
  EXPECT_LE(worst_imbalance(all), 1e-8);
  const meshes::LedgerRow &a = one.ledger.back(), &b = all.ledger.back();
  const double water = 10 * problem.tolerance * a.rain_asked;
  EXPECT_NEAR(a.rain_asked, b.rain_asked, 1e-12 * a.rain_asked);
  EXPECT_NEAR(a.stored, b.stored, water);
  EXPECT_NEAR(a.outflow, b.outflow, water);
  EXPECT_NEAR(a.run_off, b.run_off, water);
  ASSERT_EQ(one.rain_by_node.size(), all.rain_by_node.size());
  for (std::size_t i = 0; i < one.rain_by_node.size(); ++i) {
    EXPECT_EQ(one.rain_by_node[i].node, all.rain_by_node[i].node);
    EXPECT_NEAR(one.rain_by_node[i].asked, all.rain_by_node[i].asked, 1e-12 * a.rain_asked);
    EXPECT_NEAR(one.rain_by_node[i].run_off, all.rain_by_node[i].run_off, water);
  }
  ASSERT_EQ(one.sides.size(), all.sides.size());
  for (std::size_t s = 0; s < one.sides.size(); ++s) {
    EXPECT_NEAR(one.sides[s].outflow.back(), all.sides[s].outflow.back(), water) << one.sides[s].side;
  }
}

TEST(SharedSolve, StripAgreesWithOneRank) {
  agrees(strip());
  const meshes::FieldHistory one = march_alone(strip(), nullptr), all = solve(strip());
  EXPECT_GT(one.ledger.back().run_off, 0);  // it ponds: the active set crosses ranks
  EXPECT_NEAR(one.gauges[0].pressure.back(), all.gauges[0].pressure.back(), 10 * 1e-4 * unit_weight);
}

TEST(SharedSolve, QuadraticStripAgreesWithOneRank) {
  RichardsProblem problem = strip();
  problem.degree = 2;
  problem.boundary[0] = RainSide{"top", {{0}, {5e-5}}};
  problem.end_time = 500;
  problem.output_times = {500};
  const meshes::FieldHistory one = march_alone(problem, nullptr), all = solve(problem);
  EXPECT_LE(worst_difference(one, all), 10 * problem.tolerance);
}

TEST(SharedSolve, BlockAgreesWithOneRank) {
  agrees(block());
}

TEST(SharedSolve, ErrorsReachTheLeaderAndLeaveTheRanksReady) {
  RichardsProblem outside = strip();
  outside.gauges[0].position = {5, 5, 0};
  EXPECT_THROW(solve(outside), std::invalid_argument);
  RichardsProblem hopeless = strip();  // at -1 m exp(-800) underflows: no capacity and no conductivity are left
  hopeless.soils = {{"absurd", ExponentialRetention{0.1, 0.4, 800}, ExponentialConductivity{800}, 1e-4, 0, 0}};
  hopeless.initial_head.assign(hopeless.initial_head.size(), -1.0);
  hopeless.boundary = {RainSide{"top", {{500}, {1e-3}}}};
  try {
    const meshes::FieldHistory history = solve(hopeless);
    ADD_FAILURE() << "solved in " << history.counters.at("steps") << " steps";
  } catch (const GaveUp& gave_up) {
    EXPECT_NE(std::string(gave_up.what()).find("gave up at t = 500"), std::string::npos) << gave_up.what();
    EXPECT_EQ(gave_up.partial.ledger.back().time, 500);
  }
  agrees(block());
}

TEST(SharedSolve, OneDimensionIsSolvedByTheLeaderAlone) {
  RichardsProblem column = seed_column(40, 0.087, 3e-5, 1000);
  column.output_times = {1000};
  const meshes::FieldHistory history = solve(column);
  EXPECT_EQ(history.counters.count("ranks"), 0);
  ASSERT_FALSE(history.log.empty());
  EXPECT_EQ(history.log.back(), "solved on one rank of several: one dimension");
}

}  // namespace
}  // namespace wetfront::fem_reference

int main(int argc, char** argv) {
  const wetfront::fem_reference::Parallel parallel;
  if (!parallel.leads()) return parallel.serve();
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
