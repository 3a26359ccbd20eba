// A run cut after any step and continued gives the same bits as an uninterrupted one.
#include "mpm/simulation.h"
#include "tests/mpm/continuation.h"
#include "tests/mpm/strip.h"

#include <gtest/gtest.h>

namespace wetfront::mpm {
namespace {

TEST(Restart, SeepageThroughRainBreaksAndPonding) {
  Problem<2> problem = test::seed_column(10, 0.87, 3e-4, 150);  // fills and ponds at 105 s
  problem.water_boundary = {RainSide{"top", {{0, 50}, {3e-4, 3.5e-4}}, "o"}, PressureSide{"base", 500, "o"}};
  problem.output_times = {40, 140};
  problem.probes = {{"P", {0.01, 0.5, 0}, "o"}};
  test::expect_continuation(problem, 7);
}

TEST(Restart, OverAChangeOfStage) {
  Problem<2> problem = test::seed_column(10, 0.87, 3e-4, 30);
  problem.stages.push_back(problem.stages[0]);
  problem.stages[1].end_time = 60;
  problem.stages[1].integrator = TimeIntegrator::backward_euler;
  test::expect_continuation(problem, 5);
}

TEST(Restart, ElasticSkeletonWithPointsThatChangeCells) {
  Problem<2> problem = test::seed_column(8, 0.087, 0, 0.3);
  problem.water.reset();
  problem.initial_pressure.clear();
  problem.water_boundary.clear();
  problem.soils[0].elastic = Elastic{1e5, 0.3, "o"};  // so soft that points cross cells
  problem.stages[0].liquid.reset();
  problem.stages[0].local_damping = 0.05;
  problem.fixities = {
      {"base", {true, true, false}, "o"}, {"left", {true, false, false}, "o"}, {"right", {true, false, false}, "o"}};
  problem.output_times = {0.1, 0.3};
  // Numbers the points of a cell along its height: points that stay and points that leave alternate in memory, and
  // sorting them is not the identity.
  for (std::size_t cell = 0; cell < problem.mesh.cell_count(); ++cell)
    std::rotate(&problem.mesh.cells[4 * cell], &problem.mesh.cells[4 * cell] + 1, &problem.mesh.cells[4 * cell] + 4);
  Simulation<2> probe(problem);
  const auto before = probe.state().fields.at("points per cell");
  while (!probe.finished()) probe.step();
  ASSERT_NE(before, probe.state().fields.at("points per cell"));
  // Points are where the cells that claim them are: cell k spans h k to h (k+1), h = 0.15 m.
  const State end = probe.state();
  const auto& height = end.fields.at("point.position");
  std::size_t point = height.size() / 2;
  for (std::size_t cell = 0; cell < 8; ++cell)
    for (int k = 0; k < static_cast<int>(end.fields.at("points per cell")[cell]); ++k, ++point) {
      EXPECT_GE(height[point], 0.15 * static_cast<double>(cell) - 1e-9);
      EXPECT_LE(height[point], 0.15 * static_cast<double>(cell + 1) + 1e-9);
    }
  test::expect_continuation(problem, 4);
}

TEST(Restart, RefusesTheStateOfAnotherProblem) {
  const Problem<2> small = test::seed_column(10, 0.87, 3e-4, 30), large = test::seed_column(20, 0.87, 3e-4, 30);
  const State state = Simulation<2>(small).state();
  EXPECT_THROW(Simulation<2>(large, state), CannotPlan);
}

}  // namespace
}  // namespace wetfront::mpm
