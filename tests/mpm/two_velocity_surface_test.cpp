#include "tests/mpm/plane.h"
#include "tests/mpm/two_velocity_scenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

/// The two-velocity pore liquid below a free surface inside cells, and its pressures in two dimensions.
namespace wetfront::mpm::test {
namespace {

/// The seed column of 20 cells of 6 cm, its top cell filled to f.
Problem<2> cut_column(const meshes::Mesh& mesh, double height, double end_time) {
  Problem<2> problem = seed_column(1, 0.87, 1.5e-4, end_time);
  problem.mesh = mesh;
  problem.initial_pressure.clear();
  for (const auto& node : mesh.nodes) problem.initial_pressure.push_back(-std::min(9810.0 * node[1], 10e3));
  problem.output_times = {end_time};
  if (height < mesh.nodes.back()[1]) {
    problem.surface = {{-1, height, 0}, {1, height, 0}};
    problem.water_boundary = {RainSide{free_surface, {{0.0}, {1.5e-4}}, "test:rain"}};
  }
  return problem;
}

struct Outcome {
  double error;      ///< relative L2 of cell averages against 400 cells of seepage
  double delivered;  ///< stored over asked
};

Outcome under_rain(double f) {
  constexpr double h = 0.06, end = 120;
  constexpr int cells = 20, fine_cells = 400;
  const double height = (cells - 1 + f) * h;
  const auto fine = run(cut_column(strip(height, fine_cells), height, end)).snapshots.at(0).node_pressure;
  const auto history = run(with_two_velocities(cut_column(strip(cells * h, cells), height, end)));
  double error = 0, size = 0;
  for (int c = 0; c < cells; ++c) {
    const double low = c * h, part = (std::min(height, low + h) - low) / 100;
    double mean = 0;
    for (int k = 0; k < 100; ++k) {
      const double place = (low + (k + 0.5) * part) / height * fine_cells;
      const auto below = static_cast<std::size_t>(place);
      const double share = place - static_cast<double>(below);
      mean += ((1 - share) * fine[2 * below] + share * fine[2 * below + 2]) / 100;
    }
    const double off = history.snapshots.at(0).cell_pressure[static_cast<std::size_t>(c)] - mean;
    error += part * off * off;
    size += part * mean * mean;
  }
  return {std::sqrt(error / size), delivered_share(history, 0)};
}

/// Issue 3: at most max(twice the aligned error, 0.3 %) wherever the surface lies. (0.77 % aligned, 0.67 to 0.77 %
/// measured. A cell filled to 0.02 takes 160,000 steps: two_velocity_bisection_test.cpp has its stability.)
TEST(TwoVelocitySurface, RainIsAsAccurateWhereverInACellTheSurfaceLies) {
  const Outcome aligned = under_rain(1);
  EXPECT_LT(aligned.error, 0.01);
  for (double f : {0.98, 0.75, 0.5, 0.25}) {
    const Outcome cut = under_rain(f);
    EXPECT_LE(cut.error, std::max(2 * aligned.error, 0.003)) << f;
    EXPECT_NEAR(cut.delivered, 1, 1e-10) << f;
  }
}

/// A surface that slopes through squares takes rain per horizontal area, and loses none of it.
TEST(TwoVelocitySurface, SlopesThroughCellsTakeRainPerHorizontalArea) {
  Problem<2> problem = with_two_velocities(seed_column(1, 0.87, 0, 5));
  problem.mesh = box(1, 1, 10, 10);
  problem.initial_pressure.assign(problem.mesh.node_count(), -5000);
  problem.surface = {{-1, 0.1, 0}, {2, 1.0, 0}};
  problem.water_boundary = {RainSide{free_surface, {{0.0}, {3e-5}}, "test:rain"}};
  const auto history = run(problem);
  const auto &first = history.ledger.front(), &last = history.ledger.back();
  EXPECT_NEAR(last.rain_asked, 3e-5 * 5 * 1.0, 1e-12);
  EXPECT_NEAR(last.infiltrated + last.run_off, last.rain_asked, 1e-14);
  EXPECT_NEAR((last.stored - first.stored) / (last.infiltrated - last.outflow), 1, 1e-9);
}

/// Coefficient of the checkerboard among the cells of an n x n box, and the rms of all the rest but the mean.
struct Pattern {
  double checkerboard, rest;
};
Pattern pattern(const std::vector<double>& p, std::size_t n) {
  double mean = 0, board = 0, square = 0;
  const auto sign = [n](std::size_t c) { return (c / n + c % n) % 2 == 0 ? 1.0 : -1.0; };
  const double count = static_cast<double>(p.size());
  for (std::size_t c = 0; c < p.size(); ++c) mean += p[c] / count, board += sign(c) * p[c] / count;
  for (std::size_t c = 0; c < p.size(); ++c) square += std::pow(p[c] - mean - sign(c) * board, 2) / count;
  return {std::abs(board), std::sqrt(square)};
}

/// A closed saturated box that starts from random pressures comes to rest uniformly: no checkerboard is left behind on
/// either mesh (it is damped through the cells at the walls). 1e-6 of the start.
TEST(TwoVelocitySurface, ClosedBoxKeepsNoCheckerboard) {
  for (bool crooked : {false, true}) {
    Problem<2> problem = with_two_velocities(seed_column(1, 0.087, 0, 0.5));
    problem.mesh = crooked ? crooked_box(0.4, 0.4, 10, 10) : box(0.4, 0.4, 10, 10);
    problem.gravity = {0, 0};
    problem.water_boundary.clear();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> noise(0, 1e4);
    for (std::size_t i = 0; i < problem.mesh.node_count(); ++i)
      problem.initial_pressure.resize(problem.mesh.node_count()), problem.initial_pressure[i] = noise(random);
    problem.output_times = {0, 0.5};
    const auto history = run(problem);
    const Pattern start = pattern(history.snapshots[0].cell_pressure, 10);
    const Pattern end = pattern(history.snapshots[1].cell_pressure, 10);
    EXPECT_GT(start.checkerboard, 10);
    EXPECT_LT(end.checkerboard, 1e-6 * start.checkerboard);
    EXPECT_LT(end.rest, 1e-6 * start.rest);
  }
}

/// Water at rest stays at rest in crooked cells too: a pressure of one value per cell pushes on their nodes as the
/// hydrostatic one does only with what hangs in the cell (cells.cpp). Without that it drifts by some 18 Pa in a second.
TEST(TwoVelocitySurface, HydrostaticWaterRestsInCrookedCells) {
  Problem<2> problem = with_two_velocities(seed_column(1, 0.087, 0, 0.2));
  problem.mesh = crooked_box(1, 1, 10, 10);
  problem.water_boundary.clear();
  problem.initial_pressure.clear();
  for (const auto& x : problem.mesh.nodes) problem.initial_pressure.push_back(50e3 + 9810 * (0.5 - x[1]));
  problem.output_times = {0, 0.2};
  const auto history = run(problem);
  const auto &start = history.snapshots[0].cell_pressure, &end = history.snapshots[1].cell_pressure;
  for (std::size_t c = 0; c < start.size(); ++c) EXPECT_NEAR(end[c], start[c], 1e-3) << c;
}

}  // namespace
}  // namespace wetfront::mpm::test
