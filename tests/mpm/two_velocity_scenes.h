#pragma once

#include "mpm/simulation.h"
#include "tests/mpm/strip.h"

#include <numeric>

/// Scenes of the two-velocity pore liquid.
namespace wetfront::mpm::test {

/// Lets the problem's (only) stage use two velocities from the start.
inline Problem<2> with_two_velocities(Problem<2> problem) {
  problem.stages.back().liquid = LiquidScheme::implicit_drag;
  return problem;
}

/// The seed column: seepage up to 25 % of the filling time, two velocities up to `until` of it. Snapshots at the two.
inline Problem<2> window(int cells, double s_min, double intensity, double until) {
  Problem<2> problem = seed_column(cells, s_min, intensity, 1);
  const double filling = filling_time(problem, intensity);
  problem.stages[0].end_time = 0.25 * filling;
  Stage second = problem.stages[0];
  second.name = "window";
  second.liquid = LiquidScheme::implicit_drag;
  second.end_time = until * filling;
  problem.stages.push_back(second);
  problem.output_times = {0.25 * filling, until * filling};
  return problem;
}

/// A hydrostatic column of 1 m without rain, its suction not capped.
inline Problem<2> at_rest(int cells, double end_time) {
  Problem<2> problem = with_two_velocities(seed_column(1, 0.087, 0, end_time));
  problem.mesh = strip(1.0, cells);
  problem.initial_pressure.clear();
  for (const auto& node : problem.mesh.nodes) problem.initial_pressure.push_back(-9810.0 * node[1]);
  problem.output_times = {0, end_time};
  return problem;
}

/// The seed paper's skeleton (Table 1) under the column: fixed at its base, on rollers at its sides.
inline Problem<2> with_elastic_skeleton(Problem<2> problem) {
  for (Soil& soil : problem.soils) soil.elastic = Elastic{10e6, 0.3, "test:elastic"};
  problem.fixities = {{"base", {true, true, true}, "test:fixity"},
                      {"left", {true, false, false}, "test:fixity"},
                      {"right", {true, false, false}, "test:fixity"}};
  return problem;
}

/// A layer 0.4 m thick (measured vertically) and 1 m long on a 30 degree slope, parallelogram cells, the surface rained
/// upon and a kink in its middle when `kinked` (the upper half lies flat).
inline Problem<2> slope(double intensity, double end_time, bool kinked) {
  Problem<2> problem = with_two_velocities(seed_column(1, 0.87, intensity, end_time));
  constexpr int columns = 6, rows = 4;
  meshes::Mesh mesh;
  const auto ground = [kinked](double x) { return (kinked ? std::min(x, 0.5) : x) * std::tan(M_PI / 6); };
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) {
      const double x = static_cast<double>(column) / columns;
      mesh.nodes.push_back({x, ground(x) + 0.1 * row, 0});
    }
  meshes::Side base{"base", {}}, top{"top", {}}, left{"left", {}}, right{"right", {}};
  const auto node = [](int row, int column) { return row * (columns + 1) + column; };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      for (int corner : {node(row, column), node(row, column + 1), node(row + 1, column + 1), node(row + 1, column)})
        mesh.cells.push_back(corner);
      mesh.region.push_back(0);
    }
  for (int column = 0; column < columns; ++column) {
    for (int end : {node(0, column), node(0, column + 1)}) base.faces.push_back(end);
    for (int end : {node(rows, column), node(rows, column + 1)}) top.faces.push_back(end);
  }
  for (int row = 0; row < rows; ++row) {
    for (int end : {node(row, 0), node(row + 1, 0)}) left.faces.push_back(end);
    for (int end : {node(row, columns), node(row + 1, columns)}) right.faces.push_back(end);
  }
  mesh.region_names = {"soil"};
  mesh.sides = {base, top, left, right};
  problem.mesh = mesh;
  problem.initial_pressure.assign(mesh.node_count(), -8000.0);
  return problem;
}

/// The same column in three dimensions: a stack of cubes.
inline Problem<3> stack(const Problem<2>& column, int cells, double height) {
  Problem<3> problem;
  const double h = height / cells;
  meshes::Mesh& mesh = problem.mesh;
  mesh.dim = 3;
  meshes::Side base{"base", {0, 1, 2, 3}}, top{"top", {}};
  for (int k = 0; k <= cells; ++k)
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, std::pair{h, 0.0}, std::pair{h, h}, std::pair{0.0, h}})
      mesh.nodes.push_back({x, y, k * h});
  for (int k = 0; k < cells; ++k) {
    for (int node = 4 * k; node < 4 * k + 8; ++node) mesh.cells.push_back(node);
    mesh.region.push_back(0);
  }
  for (int node = 4 * cells; node < 4 * cells + 4; ++node) top.faces.push_back(node);
  mesh.region_names = {"soil"};
  mesh.sides = {base, top};
  problem.gravity = {0, 0, -9.81};
  problem.water = column.water;
  problem.soils = column.soils;
  problem.water_boundary = column.water_boundary;
  for (int k = 0; k <= cells; ++k)
    for (int corner = 0; corner < 4; ++corner)
      problem.initial_pressure.push_back(column.initial_pressure[static_cast<std::size_t>(2 * k)]);
  problem.points_per_cell = 8;
  problem.stages = column.stages;
  problem.output_times = column.output_times;
  return problem;
}

/// Relative L2 distance of cell pressures from the averages of a finer column's cells.
inline double distance(const meshes::Snapshot& coarse, const meshes::Snapshot& fine) {
  const std::size_t parts = fine.cell_pressure.size() / coarse.cell_pressure.size();
  double error = 0, size = 0;
  for (std::size_t c = 0; c < coarse.cell_pressure.size(); ++c) {
    const auto first = fine.cell_pressure.begin() + static_cast<std::ptrdiff_t>(c * parts);
    const double mean =
        std::accumulate(first, first + static_cast<std::ptrdiff_t>(parts), 0.0) / static_cast<double>(parts);
    error += (coarse.cell_pressure[c] - mean) * (coarse.cell_pressure[c] - mean);
    size += mean * mean;
  }
  return std::sqrt(error / size);
}

/// Water that came to be stored between the first ledger row at or after `from` and the last, over the rain asked.
inline double delivered_share(const meshes::FieldHistory& history, double from) {
  const auto& ledger = history.ledger;
  const auto first = std::find_if(ledger.begin(), ledger.end(), [from](const auto& row) { return row.time >= from; });
  return (ledger.back().stored - first->stored) / (ledger.back().rain_asked - first->rain_asked);
}

inline double largest(const std::vector<double>& values) {
  double most = 0;
  for (double value : values) most = std::max(most, std::abs(value));
  return most;
}

}  // namespace wetfront::mpm::test
