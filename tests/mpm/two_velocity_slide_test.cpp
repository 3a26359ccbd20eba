#include "tests/mpm/continuation.h"
#include "tests/mpm/plane.h"
#include "tests/mpm/sheared_sand.h"
#include "tests/mpm/two_velocity_scenes.h"

#include <gtest/gtest.h>

/// Rained, partly saturated Mohr-Coulomb sand that slides over a kink through many cells: what a run-out asks of the
/// two-velocity liquid.
namespace wetfront::mpm::test {
namespace {

double ground(double x) {
  return x < 2.5 ? 0 : (x - 2.5) * std::tan(M_PI / 6);
}

/// 30 x 9 cells along a base that is level up to x = 2.5 m and rises by 30 degrees beyond; soil in the lowest four rows
/// from x = 3 m on, its lower half saturated, on a base of 20 degrees.
Problem<2> wet_slope(double end) {
  constexpr double height = 0.6;
  Problem<2> problem = with_two_velocities(seed_column(1, 0.087, 0, end));
  problem.mesh = plane(30, 9, [](double u, double v) {
    const double x = 7.5 * u;
    return meshes::Point{x, ground(x) + height * 9 / 4 * v, 0};
  });
  problem.soils[0].elastic = Elastic{10e6, 0.3, "test:elastic"};
  problem.soils[0].law = MohrCoulomb{34 * M_PI / 180, 0, 0, {}, "test:law"};
  problem.gravity = {0, -9.81};
  problem.fixities = {{"left", {true, false, false}, "test:left"}, {"right", {true, false, false}, "test:right"}};
  problem.skeleton_boundary = {FrictionalContact{"base", std::tan(20 * M_PI / 180), "test:base"}};
  problem.initial_stress = InitialStress::k0;
  problem.skeleton.pic = 0.001;
  problem.initial_pressure.clear();
  for (const auto& x : problem.mesh.nodes)
    problem.initial_pressure.push_back(std::max(-4e3, 9810 * (height / 2 - (x[1] - ground(x[0])))));
  for (std::size_t c = 0; c < problem.mesh.cell_count(); ++c) {
    const auto x = problem.mesh.cell_centre(c);
    problem.empty_cells.push_back(x[0] > 3 && x[1] - ground(x[0]) < height ? 0 : 1);
  }
  problem.water_boundary = {RainSide{free_surface, {{0}, {3e-5}}, "test:rain"}};
  problem.output_times = {end};
  return problem;
}

double total(const State& state, const char* column) {
  const auto& values = state.fields.at(column);
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Wet points, one to a cell, driven against the border of the mesh: alone in its cell and exactly on the border a
/// point would give the nodes behind it nothing, and their content of water would be 0/0. ("step cap" may be infinite:
/// none.)
TEST(WetPoints, HeldAtTheBorderLeaveNoNodeWithoutMass) {
  Problem<2> problem = sheared_wet_sand(64, 1, 1);
  problem.gravity = {0, 0};
  problem.fixities.clear();
  problem.initial_velocity = [](const std::array<double, 2>& x) { return std::array<double, 2>{2 + x[1], 0}; };
  problem.stages[0].end_time = 0.2;
  Simulation<2> simulation(problem);
  while (!simulation.finished()) simulation.step();
  const State state = simulation.state();
  EXPECT_GT(simulation.take_history().counters.at("points held at the mesh border"), 100);
  const double right = problem.mesh.nodes.back()[0];
  const auto& x = state.fields.at("point.position");
  EXPECT_NEAR(*std::max_element(x.begin(), x.begin() + 64), right, 1e-6 * 0.05);
  for (const auto& [name, values] : state.fields)
    if (name != "step cap")
      for (double value : values) ASSERT_TRUE(std::isfinite(value)) << name;
}

TEST(WetSlope, SlidesThroughCellsAndKeepsItsWater) {
  const double end = 1.2;
  Simulation<2> simulation(wet_slope(end));
  const State start = simulation.state();
  const double water = total(start, "point.water");
  double highest = 0;
  long steps = 0;
  while (!simulation.finished()) {
    simulation.step();
    if (++steps % 20 != 0) continue;
    highest = std::max(highest, largest(simulation.state().fields.at("node.pressure")));
  }
  const State last = simulation.state();
  const auto history = simulation.take_history();
  const auto &first_row = history.ledger.front(), &row = history.ledger.back();
  // Round-off of 1e4 steps; what rained in and seeped out of the moving surface is booked.
  EXPECT_NEAR(total(last, "point.water") - water, row.infiltrated - row.outflow, 1e-12 * water);
  EXPECT_NEAR(row.stored - first_row.stored, row.infiltrated - row.outflow, 1e-12 * water);
  EXPECT_NEAR(row.infiltrated + row.run_off, row.rain_asked, 1e-15);
  EXPECT_GT(row.infiltrated, 0);
  EXPECT_EQ(last.fields.at("point.water").size(), start.fields.at("point.water").size());
  EXPECT_EQ(history.counters.at("points held at the mesh border"), 0);
  EXPECT_GT(history.counters.at("points that changed cells"), 1000);
  // A tenth of rho c v, what 2.5 m/s of saturated soil would press at a dead stop (470 m/s, 2 t/m3). Measured 15 to 80
  // kPa, in single cells, where the flow turns at the kink.
  EXPECT_LT(highest, 230e3);
  const auto& motion = history.motion.back();
  EXPECT_GT(motion.kinetic, 1e3) << "it slides";
  EXPECT_LT(motion.drift, 0.01 * motion.kinetic) << "mapping loses energy, it makes none";
  for (double drift : motion.momentum_drift) EXPECT_NEAR(drift, 0, 1e-9 * motion.motion);
}

/// All of it full of water under seven times the rain that it can take: its surface ponds and seeps while cells fill
/// and empty.
TEST(WetSlope, PondsWhileItSlides) {
  Problem<2> problem = wet_slope(0.9);
  for (std::size_t i = 0; i < problem.initial_pressure.size(); ++i) problem.initial_pressure[i] += 9810 * 0.3;
  problem.water_boundary = {RainSide{free_surface, {{0}, {2e-3}}, "test:rain"}};
  const auto history = run(problem);
  const auto &first = history.ledger.front(), &last = history.ledger.back();
  EXPECT_NEAR(last.stored - first.stored, last.infiltrated - last.outflow, 1e-12 * first.stored);
  EXPECT_NEAR(last.infiltrated + last.run_off, last.rain_asked, 1e-12 * last.rain_asked);
  EXPECT_GT(last.run_off, 0.1 * last.rain_asked);
  EXPECT_GT(last.infiltrated, 0.05 * last.rain_asked);
  EXPECT_GT(history.counters.at("points that changed cells"), 500);
  for (double p : history.snapshots.back().cell_pressure)
    if (!std::isnan(p)) EXPECT_LT(std::abs(p), 230e3);
}

TEST(WetSlope, CutAndContinueGivesTheSameBitsWhileItYields) {
  const Problem<2> problem = wet_slope(0.35);
  expect_continuation_at(problem, 0.25);
}

}  // namespace
}  // namespace wetfront::mpm::test
