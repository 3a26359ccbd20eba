// The rainfall boundary where the surface lies inside cells: error over the filled part f of the top cell, for the
// default and the named variants, and on a slope of 30 degrees.
#include "mpm/simulation.h"
#include "tests/mpm/plane.h"
#include "tests/mpm/strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace wetfront::mpm {
namespace {

constexpr double height = 0.6;  // m, of the soil
constexpr int cells = 20;       // of the soil where it is aligned

/// Soil of `height` under rain in a strip whose top cell it fills to f (1: the mesh ends there).
Problem<2> column(double f, int of_cells, double intensity, double time) {
  const double h = height / (of_cells - 1 + f);
  Problem<2> problem = test::seed_column(1, 0.087, intensity, time);
  problem.mesh = test::strip(f < 1 ? h * (of_cells + 1) : height, f < 1 ? of_cells + 1 : of_cells);
  problem.initial_pressure.clear();
  problem.initial_pressure.assign(problem.mesh.node_count(), -6e3);
  if (f < 1) problem.surface = {{0, height, 0}, {h, height, 0}};
  problem.water_boundary = {RainSide{f < 1 ? free_surface : "top", {{0}, {intensity}}, "o"}};
  problem.output_times = {time};
  return problem;
}

/// Pressure at heights y of a strip, linear between its levels.
double at(const meshes::FieldHistory& history, double y) {
  const auto& nodes = history.mesh.nodes;
  std::size_t k = 2;
  while (k + 2 < nodes.size() && nodes[k][1] < y) k += 2;
  const double t = (y - nodes[k - 2][1]) / (nodes[k][1] - nodes[k - 2][1]);
  const auto& p = history.snapshots.front().node_pressure;
  return (1 - t) * p[k - 2] + t * p[k];
}

/// Relative L2 error of pressure over the soil against a fine run.
double error(const meshes::FieldHistory& run, const meshes::FieldHistory& fine) {
  double square = 0, size = 0;
  for (int i = 0; i < 400; ++i) {
    const double y = height * (i + 0.5) / 400, reference = at(fine, y), value = at(run, y);
    square += (value - reference) * (value - reference);
    size += reference * reference;
  }
  return std::sqrt(square / size);
}

void expect_delivery(const meshes::FieldHistory& history) {
  const auto &first = history.ledger.front(), &last = history.ledger.back();
  EXPECT_NEAR(last.stored - first.stored, last.rain_asked - last.run_off - last.outflow, 1e-6 * last.rain_asked);
  for (const auto& node : history.rain_by_node)
    EXPECT_NEAR(node.asked - node.run_off, node.imposed, 1e-6 * node.asked + 1e-18);
}

const std::vector<double> fills{0.02, 0.1, 0.25, 0.5, 0.75, 0.9, 0.98};

TEST(RainInsideCells, IsAsAccurateAsAtACellsFace) {
  const double intensity = 5e-5, time = 900;
  const auto fine = run<2>(column(1, 320, intensity, time));
  const double aligned = error(run<2>(column(1, cells, intensity, time)), fine);
  std::printf("aligned: %.4f %%\n", 100 * aligned);
  for (double f : fills) {
    Problem<2> problem = column(f, cells, intensity, time);
    const auto standard = run<2>(problem);
    expect_delivery(standard);
    EXPECT_NEAR(standard.ledger.back().rain_asked / (problem.mesh.nodes[1][0] * intensity * time), 1, 1e-12);
    const double e = error(standard, fine);
    EXPECT_LE(e, std::max(2 * aligned, 0.003)) << f;
    // Shown, not gated: the same mesh and points, rain elsewhere.
    problem.rain_scheme = RainScheme::martinelli_2020;
    const auto outer = run<2>(problem);
    expect_delivery(outer);
    problem.rain_scheme = RainScheme::bandara_2016;
    const auto at_points = run<2>(problem);
    expect_delivery(at_points);
    std::printf(
        "f = %.2f: standard %.4f %%, martinelli_2020 %.4f %%, bandara_2016 %.4f %%; surface p %.1f %.1f %.1f %.1f Pa\n",
        f, 100 * e, 100 * error(outer, fine), 100 * error(at_points, fine), at(standard, height), at(outer, height),
        at(at_points, height), at(fine, height));
  }
}

TEST(RainInsideCells, PondsWithoutOvershoot) {
  const double intensity = 6e-4, time = 400;  // twice K_s: ponds while the front goes down
  const auto aligned = run<2>(column(1, cells, intensity, time));
  for (double f : fills) {
    const Problem<2> problem = column(f, cells, intensity, time);
    Simulation<2> simulation(problem);
    double most = -1e9;
    const std::size_t top = problem.mesh.nodes.size() - 4;  // node below the last, empty cell: outside the soil
    while (!simulation.finished()) {
      simulation.step();
      const auto state = simulation.state();
      const auto& p = state.fields.at("node.pressure");
      most = std::max(most, (1 - f) * p[top - 2] + f * p[top]);
    }
    const auto history = simulation.take_history();
    EXPECT_LT(most, 1) << f;
    expect_delivery(history);
    EXPECT_GT(history.ledger.back().run_off, 0.1 * history.ledger.back().rain_asked);
    EXPECT_LT(std::abs(history.ledger.back().outflow),
              1e-6 * history.ledger.back().rain_asked);  // what is refused ran off
    // The same share is refused as at an aligned surface, to the error of this mesh.
    const auto share = [](const meshes::FieldHistory& h) {
      return h.ledger.back().run_off / h.ledger.back().rain_asked;
    };
    EXPECT_NEAR(share(history), share(aligned), 0.02) << f;
    std::printf("f = %.2f: highest surface pressure %.3g Pa, refused %.4f (aligned %.4f)\n", f, most, share(history),
                share(aligned));
  }
}

TEST(RainInsideCells, PressuresAndLevelsActThereToo) {
  const double time = 300;
  const auto with = [&](double f, const WaterBoundary& condition) {
    Problem<2> problem = column(f, cells, 0, time);
    problem.water_boundary = {condition};
    return run<2>(problem);
  };
  const WaterLevelSide level{free_surface, {{0, 150}, {height + 0.1, height + 0.2}}, {}, "o"};
  WaterLevelSide level_on_top = level;
  level_on_top.side = "top";
  const auto held = with(1, PressureSide{"top", 500, "o"}), flooded = with(1, level_on_top);
  for (double f : fills) {
    const auto cut = with(f, PressureSide{free_surface, 500, "o"});
    EXPECT_NEAR(at(cut, height), 500, 10) << f;  // the film's share of the drop over a cell, 1e-3 of a suction of 6 kPa
    // Water taken up per width, against the same with the surface on a face.
    const auto taken = [](const meshes::FieldHistory& h) { return -h.ledger.back().outflow / h.mesh.nodes[1][0]; };
    EXPECT_NEAR(taken(cut) / taken(held), 1, 0.01) << f;
    const auto under_water = with(f, level);
    EXPECT_NEAR(at(under_water, height), 9810 * 0.2, 10) << f;
    EXPECT_NEAR(taken(under_water) / taken(flooded), 1, 0.01) << f;
    const auto &first = cut.ledger.front(), &last = cut.ledger.back();
    EXPECT_NEAR(last.stored - first.stored, -last.outflow, 1e-8 * std::abs(last.outflow));
    EXPECT_NEAR(cut.sides[0].outflow.back(), last.outflow, 1e-12);
  }
}

/// A layer of depth d at 30 degrees in a mesh of level cells, so that the surface cuts through them all.
TEST(RainInsideCells, ASlopeOfThirtyDegreesThroughLevelCells) {
  const double angle = std::acos(-1.0) / 6, intensity = 5e-5, time = 600, length = 1.2;
  // Impermeable base parallel to the surface: cells follow it, but are cut by the surface at a shifting place.
  const int nx = 24, ny = 12;
  const double slope = std::tan(angle), depth = 0.35;
  Problem<2> problem = test::seed_column(1, 0.087, intensity, time);
  // Cells rise with the slope in steps of their own: rows are level lines, columns vertical; the base follows the
  // slope.
  problem.mesh = test::plane(nx, ny, [&](double u, double v) {
    const double x = u * length, base = slope * x;
    return meshes::Point{x, base + v * (depth * 1.3 + 0.12 * depth * std::sin(9 * u)), 0};
  });
  problem.initial_pressure.assign(problem.mesh.node_count(), -6000);
  problem.surface = {{0, depth, 0}, {length, depth + slope * length, 0}};
  problem.water_boundary = {RainSide{free_surface, {{0}, {intensity}}, "o"}};
  problem.output_times = {time};
  const auto cut = run<2>(problem);
  expect_delivery(cut);
  EXPECT_NEAR(cut.ledger.back().rain_asked, length * intensity * time, 1e-9 * length * intensity * time);
  // Against the level column of the same vertical depth: at mid-length, before the ends are felt, the layer depends on
  // the depth normal to it only (sloping layer: gravity g cos, rain I cos).
  Problem<2> level = test::seed_column(1, 0.087, intensity * std::cos(angle), time);
  level.gravity = {0, -9.81 * std::cos(angle)};
  level.mesh = test::strip(depth * std::cos(angle), 320);
  level.initial_pressure.assign(level.mesh.node_count(), -6000);
  level.output_times = {time};
  const auto fine = run<2>(level);
  level.mesh = test::strip(depth * std::cos(angle), 9);  // the cells of the slope: depth 0.35 m of 1.3 x 0.35 m in 12
  level.initial_pressure.assign(level.mesh.node_count(), -6000);
  const auto coarse = run<2>(level);
  double square = 0, square_coarse = 0, size = 0;
  for (int j = 0; j <= ny; ++j) {
    const auto node = static_cast<std::size_t>(j * (nx + 1) + nx / 2);
    const auto& x = problem.mesh.nodes[node];
    const double normal = (x[1] - slope * x[0]) * std::cos(angle);  // above the base
    if (normal > depth * std::cos(angle)) continue;
    const double reference = at(fine, normal);
    square += std::pow(cut.snapshots[0].node_pressure[node] - reference, 2);
    square_coarse += std::pow(at(coarse, normal) - reference, 2);
    size += reference * reference;
  }
  const double error_cut = std::sqrt(square / size), error_level = std::sqrt(square_coarse / size);
  std::printf("30 degrees: %.4f %%, level %.4f %%\n", 100 * error_cut, 100 * error_level);
  EXPECT_LE(error_cut, std::max(2 * error_level, 0.003));
}

}  // namespace
}  // namespace wetfront::mpm
