// Seepage where it is hard: very dry starts, clay, starts above zero pressure, water without compressibility.
#include "mpm/simulation.h"
#include "tests/mpm/strip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wetfront::mpm {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Ends, with a finite pressure everywhere and its balance closed to 1e-8 of what went in or out.
meshes::FieldHistory run_balanced(Problem<2> problem) {
  problem.output_times = {problem.stages[0].end_time};
  problem.stages[0].time_tolerance = 1e-4;
  const auto history = run<2>(problem);
  const auto &first = history.ledger.front(), &last = history.ledger.back();
  EXPECT_EQ(last.time, problem.stages[0].end_time);
  EXPECT_NEAR(last.stored - first.stored, last.infiltrated - last.outflow,
              1e-8 * std::max(last.rain_asked, last.outflow) + 1e-12 * last.stored);
  EXPECT_NEAR(last.rain_asked, last.infiltrated + last.run_off, 1e-6 * last.rain_asked);
  EXPECT_NEAR(last.stored_points, last.stored, 1e-12 * last.stored);
  for (double p : history.snapshots[0].node_pressure) EXPECT_TRUE(std::isfinite(p));
  return history;
}

/// Height of the lowest left node wetter than -20 kPa.
double front(const meshes::FieldHistory& history) {
  const auto& p = history.snapshots[0].node_pressure;
  for (std::size_t i = 0; i < p.size(); i += 2)
    if (p[i] > -20e3) return history.mesh.nodes[i][1];
  return infinite;
}

class VeryDry : public ::testing::TestWithParam<double> {};

TEST_P(VeryDry, SoilTakesTheRain) {
  // K ahead of the front is ten decades and more below K behind it: K at points would shut the rain out.
  const auto dry = [](int cells) {
    Problem<2> problem = test::seed_column(cells, 0.087, 3e-5, 6000);
    problem.initial_pressure.assign(problem.mesh.node_count(), GetParam());
    return run_balanced(problem);
  };
  const auto coarse = dry(40), fine = dry(120);
  EXPECT_EQ(coarse.ledger.back().run_off, 0);
  // The front lies within a cell of where three times as many cells put it.
  EXPECT_NEAR(front(coarse), front(fine), 1.2 / 40 + 1e-9);
  // It has gone down: 0.18 m of water over theta(3e-5 m/s) - theta_dry = 0.275 as a piston, and its foot lies ahead.
  EXPECT_NEAR(1.2 - front(fine), 0.18 / 0.275, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Suctions, VeryDry, ::testing::Values(-1e5, -1e6, -1e7));

TEST(SeepageHard, AnUncappedColumnOfTwentyMetresTakesRain) {
  Problem<2> problem = test::seed_column(100, 0.087, 3e-5, 10000);
  problem.mesh = test::strip(20, 100);
  problem.initial_pressure.clear();
  for (const auto& node : problem.mesh.nodes) problem.initial_pressure.push_back(-9810 * node[1]);
  EXPECT_EQ(run_balanced(problem).ledger.back().run_off, 0);
}

TEST(SeepageHard, ClayTakesRainUntilItPonds) {
  for (double n : {1.1, 1.2}) {
    Problem<2> problem = test::seed_column(40, 0.087, 5.6e-6, 86400);
    problem.mesh = test::strip(1, 40);
    problem.initial_pressure.assign(problem.mesh.node_count(), -1e5);
    problem.soils[0].retention = VanGenuchtenRetention{12.3e3, 1 - 1 / n, 0.15, 1};
    problem.soils[0].intrinsic_permeability = 5.7e-14;  // 5.6e-7 m/s
    const auto history = run_balanced(problem);
    EXPECT_GT(history.ledger.back().run_off, 0.5 * history.ledger.back().rain_asked) << n;
    EXPECT_LE(history.snapshots[0].node_pressure.back(), 1.0) << n;
  }
}

TEST(SeepageHard, AStartUnderWaterMayRainOrDrain) {
  for (double bulk_modulus : {0.2e9, 2.15e9, infinite})
    for (const char* face : {"top", "base"}) {
      Problem<2> problem = test::seed_column(40, 0.087, 0, 2000);
      problem.water->bulk_modulus = bulk_modulus;
      const double rain = std::string(face) == "top" ? 3e-5 : 0;
      problem.water_boundary = {RainSide{face, {{0}, {rain}}, "test:face"}};
      for (std::size_t i = 0; i < problem.mesh.node_count(); ++i)
        problem.initial_pressure[i] = 9810 * (1.5 - problem.mesh.nodes[i][1]);
      const auto history = run_balanced(problem);
      const auto& p = history.snapshots[0].node_pressure;
      if (rain > 0) {
        EXPECT_NEAR(p[0], 9810 * 1.2, 1) << bulk_modulus;
      } else {
        EXPECT_LT(p.back(), -5e3) << bulk_modulus;  // drained: suction at the top
      }
    }
}

TEST(SeepageHard, RainOnAndOffThroughSaturation) {
  for (double bulk_modulus : {2.15e9, infinite}) {
    Problem<2> problem = test::seed_column(40, 0.087, 0, 10000);
    problem.water->bulk_modulus = bulk_modulus;
    meshes::RainRecord record;
    for (int k = 0; k < 10; ++k) {
      record.start.push_back(k * 1000.0);
      record.intensity.push_back(k % 2 == 0 ? 6e-4 : 0);
    }
    problem.water_boundary = {RainSide{"top", record, "test:rain"}, RainSide{"base", {{0}, {0}}, "test:base"}};
    const auto history = run_balanced(problem);
    EXPECT_GT(history.ledger.back().run_off, 0) << bulk_modulus;
    EXPECT_GT(history.ledger.back().outflow, 0) << bulk_modulus;
  }
}

TEST(SeepageHard, PermeabilityOnlySetsTheClock) {
  // k from 1e-3 to 1e-9 m/s with rain of twice that: the same run in other seconds.
  std::vector<double> steps;
  for (double k : {1e-3, 1e-6, 1e-9}) {
    Problem<2> problem = test::seed_column(40, 0.087, 2 * k, 0.4 / k);
    problem.initial_pressure.assign(problem.mesh.node_count(), -10e3);
    problem.soils[0].intrinsic_permeability = k / 9810 * 1e-3;
    steps.push_back(run_balanced(problem).counters.at("steps"));
  }
  // Steps differ by round-off in Newton's method only.
  EXPECT_NEAR(steps[0] / steps[1], 1, 0.05);
  EXPECT_NEAR(steps[2] / steps[1], 1, 0.05);
}

TEST(SeepageHard, LittlePoresAThinCoverAndADryDay) {
  Problem<2> little = test::seed_column(40, 0.087, 3e-5, 100);
  little.soils[0].porosity = 0.001;
  run_balanced(little);
  run_balanced(test::seed_column(1, 0.087, 3e-5, 5000));
  EXPECT_EQ(run_balanced(test::seed_column(40, 0.087, 0, 86400)).ledger.back().infiltrated, 0);
}

/// Conductivity follows when S reaches S_max: a ponded, drained column that is full passes K_s, not what it passed
/// before.
TEST(SeepageHard, AFullColumnPassesItsSaturatedConductivity) {
  constexpr double ks = 3e-11 * 9810 / 1e-3;
  Problem<2> problem = test::seed_column(20, 0.087, 2 * ks, 6000);
  problem.water_boundary.push_back(FreeDrainageSide{"base", "o"});
  problem.initial_pressure.assign(problem.mesh.node_count(), -10e3);
  const auto history = run_balanced(problem);
  const auto &last = history.ledger.back(), &before = history.ledger[history.ledger.size() - 2];
  const double width = 1.2 / 20;
  EXPECT_NEAR((last.outflow - before.outflow) / (last.time - before.time) / width / ks, 1, 1e-6);
  EXPECT_NEAR((last.run_off - before.run_off) / (last.time - before.time) / width / ks, 1, 1e-6);
}

/// The last pore of incompressible soil fills: the pressure jumps, the run goes on, and what follows is hydrostatic.
TEST(SeepageHard, TheLastPoreOfIncompressibleSoilMayFill) {
  for (const auto scheme : {LiquidScheme::seepage, LiquidScheme::semi_implicit}) {
    Problem<2> problem = test::seed_column(10, 0.087, 3e-4, 2000);
    problem.water->bulk_modulus = std::numeric_limits<double>::infinity();
    problem.stages[0].liquid = scheme;
    problem.stages[0].integrator = TimeIntegrator::backward_euler;
    problem.output_times = {2000};
    const auto history = run_balanced(problem);
    const auto& p = history.snapshots.back().node_pressure;
    for (std::size_t i = 0; i < p.size(); ++i) EXPECT_NEAR(p[i], 9810 * (1.2 - problem.mesh.nodes[i][1]), 1) << i;
  }
}

}  // namespace
}  // namespace wetfront::mpm
