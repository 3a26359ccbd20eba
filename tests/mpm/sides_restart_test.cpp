// Runs through every water side, cut and continued, give the same bits; long records; rain over kinks.
#include "mpm/simulation.h"
#include "tests/mpm/continuation.h"
#include "tests/mpm/plane.h"
#include "tests/mpm/strip.h"

#include <gtest/gtest.h>

namespace wetfront::mpm {
namespace {

/// A bank cut out of a box: a flat, a slope with kinks and a crest, rain with evaporation on it, a level on the left.
Problem<2> bank() {
  Problem<2> problem = test::seed_column(1, 0.087, 0, 1);
  problem.mesh = test::crooked_box(2, 1, 10, 6);
  problem.initial_pressure.clear();
  for (const auto& x : problem.mesh.nodes) problem.initial_pressure.push_back(-std::min(9810 * x[1], 5e3));
  problem.surface = {{0, 0.31, 0}, {0.6, 0.33, 0}, {1.3, 0.83, 0}, {2, 0.87, 0}};
  RainSide rain{free_surface, {{0, 900, 1500}, {4e-5, 4e-4, 0}}, "o"};
  rain.evaporation = {{0, 1500}, {0, 1e-7}};
  problem.water_boundary = {rain, WaterLevelSide{"left", {{0, 600, 1800}, {0, 0.25, 0.1}}, {}, "o"},
                            FreeDrainageSide{"base", "o"}};
  problem.stages[0].end_time = 2400;
  problem.stages[0].time_tolerance = 1e-4;
  problem.output_times = {1000, 2400};
  return problem;
}

TEST(SidesOverTime, CutAndContinuedGiveTheSameBits) {
  test::expect_continuation(bank(), 40, 7);
}

TEST(SidesOverTime, RainOverKinksIsTheWidthOfTheBodyTimesItsDepth) {
  const auto history = run<2>(bank());
  const double depth = 900 * 4e-5 + 600 * 4e-4;
  const auto &first = history.ledger.front(), &last = history.ledger.back();
  EXPECT_NEAR(last.rain_asked / (2 * depth), 1, 1e-12);
  EXPECT_GT(last.run_off, 0.02 * last.rain_asked);
  EXPECT_GT(history.sides[0].evaporated.back(), 0);
  double asked = 0;
  for (const auto& node : history.rain_by_node) {
    asked += node.asked;
    EXPECT_NEAR(node.asked - node.run_off, node.imposed, 1e-6 * std::abs(node.asked) + 1e-18);
  }
  EXPECT_NEAR(asked, last.rain_asked, 1e-14);
  EXPECT_NEAR(last.stored - first.stored, last.infiltrated - last.outflow, 1e-8 * last.rain_asked);
  // Points hold what nodes hold: they sample S elsewhere, and the cells are large.
  EXPECT_NEAR(last.stored_points - first.stored_points, last.stored - first.stored, 0.02 * last.rain_asked);
}

TEST(SidesOverTime, ARecordThatChangesInEveryRowCostsAFewStepsARow) {
  Problem<2> problem = test::seed_column(10, 0.087, 0, 6e4);
  meshes::RainRecord rain;
  for (int i = 0; i < 100000; ++i) {  // 100 of them are lived through
    rain.start.push_back(600.0 * i);
    rain.intensity.push_back(i % 3 == 0 ? 2e-6 : 1e-6 * (i % 7));
  }
  problem.water_boundary = {RainSide{"top", rain, "o"}, PressureSide{"base", 0, "o"}};
  Simulation<2> first(problem);
  while (!first.finished()) first.step();
  const auto history = first.take_history();
  EXPECT_NEAR(history.ledger.back().rain_asked, 0.12 * meshes::depth_until(rain, 6e4), 1e-12);
  EXPECT_LT(history.counters.at("steps"), 30 * 100.0);  // 1278 measured, 0.06 s: each break starts anew
  // The state of a run holds none of the record's rows.
  std::size_t numbers = 0;
  for (const auto& [name, values] : first.state().fields) numbers += values.size();
  EXPECT_LT(numbers, 2000u);
}

}  // namespace
}  // namespace wetfront::mpm
