#pragma once

#include "mpm/problem.h"
#include "tests/mpm/plane.h"

#include <algorithm>
#include <cmath>

/// Bodies whose points move from cell to cell, for tests and benchmarks.
namespace wetfront::mpm::test {

/// Cells of the body: two thirds of the mesh in each direction, in its lower middle.
struct Body {
  int cells = 0, first = 0, across = 0;  ///< of its side; first column; columns of the mesh
  explicit Body(long points, int per_cell)
      : cells(static_cast<int>(std::lround(std::sqrt(static_cast<double>(points) / per_cell)))),
        first(std::max(2, cells / 4)),
        across(cells + 2 * first) {}
};

/// Sand on a base that holds it, sheared by its own motion (the top moves at 4 m/s to the right, the base stands) and
/// collapsing under its weight: nearly all of it yields.
inline Problem<2> sheared_sand(long points, int per_cell, int threads) {
  const Body body(points, per_cell);
  constexpr double h = 0.05;
  Problem<2> problem;
  problem.mesh = box(body.across * h, (body.cells + 2) * h, body.across, body.cells + 2);
  problem.empty_cells.assign(problem.mesh.cell_count(), 1);
  for (int j = 0; j < body.cells; ++j)
    for (int i = body.first; i < body.first + body.cells; ++i)
      problem.empty_cells[static_cast<std::size_t>(j * body.across + i)] = 0;
  problem.gravity = {0, -9.81};
  Soil sand;
  sand.name = "sand";
  sand.porosity = 0.4;
  sand.grain_density = 2650;
  sand.intrinsic_permeability = 1e-11;
  sand.elastic = Elastic{10e6, 0.3, "bench"};
  sand.law = MohrCoulomb{0.52, 100, 0, {}, "bench"};
  problem.soils = {sand};
  problem.fixities = {{"base", {true, true, false}, "bench"}};
  const double height = body.cells * h;
  problem.initial_velocity = [height](const std::array<double, 2>& x) {
    return std::array<double, 2>{4 * x[1] / height, 0};
  };
  problem.points_per_cell = per_cell;
  problem.threads = threads;
  Stage stage;
  stage.name = "motion";
  stage.end_time = 1e3;
  problem.stages = {stage};
  return problem;
}

/// The same with water in its pores at 4 kPa of suction and implicit drag; no water passes its surface.
inline Problem<2> sheared_wet_sand(long points, int per_cell, int threads) {
  Problem<2> problem = sheared_sand(points, per_cell, threads);
  problem.water = Water{1000, 2e8, 1e-3, "bench"};
  problem.soils[0].retention = VanGenuchtenRetention{4350, 0.61, 0.087, 1};
  problem.soils[0].permeability = MualemPermeability{};
  problem.initial_pressure.assign(problem.mesh.node_count(), -4e3);
  problem.stages[0].liquid = LiquidScheme::implicit_drag;
  return problem;
}

}  // namespace wetfront::mpm::test
