#include "fem_reference/soil/soil_law.h"
#include "tests/fem_reference/columns.h"

#include <gtest/gtest.h>

namespace wetfront::fem_reference {
namespace {

using namespace testing;

constexpr double rains[] = {3e-5, 7.5e-5, 1.5e-4, 2.25e-4, 3e-4};  // m/s

/// The column's water deficit divided by the rain [s]; by Simpson's rule, independent of mesh and solver.
double filling_time(double s_min, double rain) {
  const SoilLaw law(seed_sand(s_min));
  const int intervals = 20000;
  double deficit = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double z = 1.2 * i / intervals;
    const double factor = i == 0 || i == intervals ? 1 : (i % 2 == 1 ? 4 : 2);
    const double head = std::max(-z, -10e3 / unit_weight);
    deficit += factor * (0.46 - law.water_content(head).value) * 1.2 / intervals / 3;
  }
  return deficit / rain;
}

RichardsProblem main_job(int cells, double s_min, double rain) {
  const double full = filling_time(s_min, rain);
  RichardsProblem problem = seed_column(cells, s_min, rain, 1.1 * full);
  problem.output_times = {0.25 * full, 0.5 * full, 0.75 * full};
  problem.gauges = {{"base", {0, 0, 0}}, {"middle", {0.605, 0, 0}}};
  return problem;
}

/// Largest L2 distance [m of head] over the snapshots, relative to the column's length.
double distance(const meshes::FieldHistory& a, const meshes::FieldHistory& b) {
  double worst = 0;
  EXPECT_EQ(a.snapshots.size(), b.snapshots.size());
  for (std::size_t s = 0; s < a.snapshots.size(); ++s) {
    double sum = 0;
    for (std::size_t i = 0; i < a.snapshots[s].node_pressure.size(); ++i) {
      sum += std::pow((a.snapshots[s].node_pressure[i] - b.snapshots[s].node_pressure[i]) / unit_weight, 2);
    }
    worst = std::max(worst, std::sqrt(sum / static_cast<double>(a.snapshots[s].node_pressure.size())));
  }
  return worst;
}

double ponding_time(const meshes::FieldHistory& history) {
  for (const meshes::LedgerRow& row : history.ledger) {
    if (row.run_off > 0) return row.time;
  }
  return history.ledger.back().time + 1;
}

// Issue 2: "its own 1e-8 solution within 1e-5 m" at 120 cells and tolerance 1e-6.
TEST(SeedColumn, ReproducesItsTightSolution) {
  for (double s_min : {0.087, 0.87}) {
    for (double rain : rains) {
      RichardsProblem problem = main_job(120, s_min, rain);
      // 1e-8 through the instant of filling is slow; two of the five intensities show that it can.
      if (rain > 1e-4) problem.end_time = problem.output_times.back();
      const meshes::FieldHistory loose = solve(problem);
      problem.tolerance = 1e-8;
      const double error = distance(loose, solve(problem));
      std::printf("  S_min %.3f, rain %.2e m/s: %.2e m, %g steps, %.3f CPU s\n", s_min, rain, error,
                  loose.counters.at("steps"), loose.cpu_seconds);
      EXPECT_LE(error, 1e-5);
    }
  }
}

// A rigid column is full when the rain has filled its pores; what the compressed water takes is sigma L^2/2 = 2e-5 m,
// 1e-4 of the deficit, and the last cell fills through K: issue 2 asks for 0.5 %.
TEST(SeedColumn, FillsWhenTheDeficitHasFallen) {
  EXPECT_NEAR(filling_time(0.87, 3e-5), 1048, 1);  // issue 2 prints 1048 s
  for (double s_min : {0.087, 0.87}) {
    for (double rain : rains) {
      const meshes::FieldHistory history = solve(main_job(120, s_min, rain));
      EXPECT_NEAR(ponding_time(history) / filling_time(s_min, rain), 1, 0.005);
      // Full and at rest, the column is hydrostatic: p(base) = rho g 1.2 m.
      EXPECT_NEAR(history.gauges[0].pressure.back(), 1.2 * unit_weight, 1e-6 * 1.2 * unit_weight);
    }
  }
}

// S_min only scales the capacity when sigma = 0: profiles at equal t/t_full agree (benchmarks.md section 4: .1 %).
TEST(SeedColumn, ResidualSaturationOnlyRescalesTime) {
  RichardsProblem wet = main_job(120, 0.87, 1.5e-4), dry = main_job(120, 0.087, 1.5e-4);
  wet.tolerance = dry.tolerance = 1e-7;
  const double scale = distance(solve(wet), solve(dry)) / (10e3 / unit_weight);
  EXPECT_LE(scale, 1e-3);
}

TEST(SeedColumn, WaterBalanceClosesThroughPonding) {
  for (Integrator integrator : {Integrator::bdf, Integrator::backward_euler}) {
    RichardsProblem problem = main_job(120, 0.087, 3e-4);
    problem.integrator = integrator;
    problem.tolerance = integrator == Integrator::bdf ? 1e-6 : 1e-4;
    const meshes::FieldHistory history = solve(problem);
    EXPECT_GT(history.ledger.back().run_off, 0);
    EXPECT_LE(worst_imbalance(history), 1e-8);
    for (const meshes::LedgerRow& row : history.ledger) {
      EXPECT_NEAR(row.rain_asked, row.infiltrated + row.run_off, 1e-14);
      // Nothing seeps out, but the BDF derivative of a node that has just ponded is not exactly zero; what then goes
      // beyond the rain is booked as outflow. 1e-11 of the rain.
      EXPECT_NEAR(row.outflow, 0, 1e-11 * history.ledger.back().rain_asked);
    }
  }
}

// Backward Euler's global error is of first order in sqrt(tol): BDF lies within the distance by which backward Euler
// itself still moves when its tolerance is cut by 16 (its step, and so its error, by about 4).
TEST(SeedColumn, BackwardEulerAgreesToItsOwnError) {
  const RichardsProblem problem = main_job(60, 0.87, 7.5e-5);
  RichardsProblem coarse = problem, fine = problem;
  coarse.integrator = fine.integrator = Integrator::backward_euler;
  coarse.tolerance = 1.6e-5;
  fine.tolerance = 1e-6;
  const meshes::FieldHistory bdf = solve(problem), first = solve(coarse), second = solve(fine);
  const double own_error = distance(first, second);
  std::printf("  BE 1.6e-5 - BE 1e-6: %.2e m; BE 1e-6 - BDF: %.2e m; BE 1.6e-5 - BDF %.2e m\n", own_error,
              distance(second, bdf), distance(first, bdf));
  EXPECT_LE(distance(second, bdf), own_error);
  EXPECT_LE(distance(second, bdf), 1e-3);
  EXPECT_LE(distance(second, bdf), 0.5 * distance(first, bdf));
}

TEST(SeedColumn, RecordIsComplete) {
  const RichardsProblem problem = main_job(24, 0.87, 1.5e-4);
  const meshes::FieldHistory history = solve(problem);
  ASSERT_EQ(history.snapshots.size(), 3U);
  for (std::size_t s = 0; s < 3; ++s) {
    const meshes::Snapshot& snapshot = history.snapshots[s];
    EXPECT_EQ(snapshot.time, problem.output_times[s]);
    ASSERT_EQ(snapshot.node_pressure.size(), 25U);
    ASSERT_EQ(snapshot.node_saturation.size(), 25U);
    ASSERT_EQ(snapshot.cell_saturation.size(), 24U);
    for (int c = 0; c < 24; ++c) {  // linear elements: the centre is the mean of the ends
      EXPECT_NEAR(snapshot.cell_pressure[c], 0.5 * (snapshot.node_pressure[c] + snapshot.node_pressure[c + 1]), 1e-9);
      EXPECT_NEAR(snapshot.cell_saturation[c],
                  SoilLaw(problem.soils[0]).saturation(snapshot.cell_pressure[c] / unit_weight), 1e-14);
    }
  }
  EXPECT_EQ(history.ledger.size(), 1 + static_cast<std::size_t>(history.counters.at("steps")));
  EXPECT_EQ(history.ledger.front().time, 0);
  EXPECT_EQ(history.ledger.back().time, problem.end_time);
  ASSERT_EQ(history.gauges.size(), 2U);
  EXPECT_EQ(history.gauges[1].time.size(), history.ledger.size());
  ASSERT_EQ(history.rain_by_node.size(), 1U);
  EXPECT_EQ(history.rain_by_node[0].node, 24);
  EXPECT_NEAR(history.rain_by_node[0].imposed, history.ledger.back().infiltrated, 1e-15);
  EXPECT_NEAR(history.rain_by_node[0].run_off, history.ledger.back().run_off, 1e-15);
  EXPECT_GT(history.cpu_seconds, 0);
  EXPECT_EQ(history.cost.size(), 4U);
}

}  // namespace
}  // namespace wetfront::fem_reference
