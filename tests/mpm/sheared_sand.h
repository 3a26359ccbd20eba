#pragma once

#include "mpm/problem.h"

#include <algorithm>
#include <cmath>

/// Bodies whose points move from cell to cell, for tests and benchmarks.
namespace wetfront::mpm::test {

/// A plane mesh of nx x ny square cells of size h, sides "base", "left", "right" and "top".
inline meshes::Mesh grid(int nx, int ny, double h) {
  meshes::Mesh mesh;
  const auto node = [nx](int i, int j) { return j * (nx + 1) + i; };
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) mesh.nodes.push_back({i * h, j * h, 0});
  mesh.sides = {{"base", {}}, {"left", {}}, {"right", {}}, {"top", {}}};
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      for (int k : {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}) mesh.cells.push_back(k);
      mesh.region.push_back(0);
    }
  for (int i = 0; i < nx; ++i) {
    for (int k : {node(i, 0), node(i + 1, 0)}) mesh.sides[0].faces.push_back(k);
    for (int k : {node(i + 1, ny), node(i, ny)}) mesh.sides[3].faces.push_back(k);
  }
  for (int j = 0; j < ny; ++j) {
    for (int k : {node(0, j + 1), node(0, j)}) mesh.sides[1].faces.push_back(k);
    for (int k : {node(nx, j), node(nx, j + 1)}) mesh.sides[2].faces.push_back(k);
  }
  mesh.region_names = {"soil"};
  return mesh;
}

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
  problem.mesh = grid(body.across, body.cells + 2, h);
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

}  // namespace wetfront::mpm::test
