#pragma once

#include "fem_reference/richards_problem.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wetfront::fem_reference::testing {

/// A vertical line of `cells` equal cells from 0 to `height` [m], sides "base" and "top", one region.
inline meshes::Mesh line_mesh(int cells, double height) {
  meshes::Mesh mesh;
  mesh.dim = 1;
  for (int i = 0; i <= cells; ++i) mesh.nodes.push_back({height * i / cells, 0, 0});
  for (int i = 0; i < cells; ++i) mesh.cells.insert(mesh.cells.end(), {i, i + 1});
  mesh.region.assign(cells, 0);
  mesh.region_names = {"soil"};
  mesh.sides = {{"base", {0}}, {"top", {cells}}};
  return mesh;
}

/// A strip one metre wide and `columns` cells across of the same column; sides "base", "top", "left", "right".
inline meshes::Mesh strip_mesh(int cells, double height, int columns) {
  meshes::Mesh mesh;
  mesh.dim = 2;
  const int row = columns + 1;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= columns; ++i) mesh.nodes.push_back({1.0 * i / columns, height * j / cells, 0});
  }
  mesh.sides = {{"base", {}}, {"top", {}}, {"left", {}}, {"right", {}}};
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = j * row + i;
      mesh.cells.insert(mesh.cells.end(), {a, a + 1, a + row + 1, a + row});
    }
    mesh.sides[2].faces.insert(mesh.sides[2].faces.end(), {j * row, (j + 1) * row});
    mesh.sides[3].faces.insert(mesh.sides[3].faces.end(), {j * row + columns, (j + 1) * row + columns});
  }
  for (int i = 0; i < columns; ++i) {
    mesh.sides[0].faces.insert(mesh.sides[0].faces.end(), {i, i + 1});
    mesh.sides[1].faces.insert(mesh.sides[1].faces.end(), {cells * row + i, cells * row + i + 1});
  }
  mesh.region.assign(static_cast<std::size_t>(cells) * columns, 0);
  mesh.region_names = {"soil"};
  return mesh;
}

/// The same column as a stack of hexahedra on a unit square; sides "base", "top".
inline meshes::Mesh stack_mesh(int cells, double height) {
  meshes::Mesh mesh;
  mesh.dim = 3;
  for (int k = 0; k <= cells; ++k) {
    for (auto [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
      mesh.nodes.push_back({x, y, height * k / cells});
    }
  }
  for (int i = 0; i < 8 * cells; ++i) mesh.cells.push_back(4 * (i / 8) + i % 8);
  mesh.sides = {{"base", {0, 1, 2, 3}}, {"top", {4 * cells, 4 * cells + 1, 4 * cells + 2, 4 * cells + 3}}};
  mesh.region.assign(cells, 0);
  mesh.region_names = {"soil"};
  return mesh;
}

constexpr double unit_weight = 9810;  // Pa/m

/// The seed paper's sand (Table 1; benchmarks.md section 4): p0 = 4.35 kPa, lambda = 0.61, n = 0.46.
inline Soil seed_sand(double s_min, double specific_storage = 0.46 * unit_weight / 0.2e9) {
  constexpr double porosity = 0.46;
  return {"sand",
          VanGenuchten{porosity * s_min, porosity, unit_weight / 4350, 1 / (1 - 0.61)},
          MualemConductivity{},
          2.943e-4,
          specific_storage,
          porosity};
}

/// The 1.2 m column of the main job: hydrostatic suction from the base, capped at 10 kPa; impermeable base, rain
/// from t = 0 on the top.
inline RichardsProblem seed_column(int cells, double s_min, double rain, double end_time) {
  RichardsProblem problem;
  problem.mesh = line_mesh(cells, 1.2);
  problem.gravity_direction = {-1, 0, 0};
  problem.unit_weight = unit_weight;
  problem.soils = {seed_sand(s_min)};
  problem.boundary = {RainSide{"top", {{0}, {rain}}}};
  for (const meshes::Point& node : problem.mesh.nodes) {
    problem.initial_head.push_back(std::max(-node[0], -10e3 / unit_weight));
  }
  problem.end_time = end_time;
  return problem;
}

/// |stored(t) - stored(0) - infiltrated + outflow| / max(infiltrated, outflow), the worst over all steps.
inline double worst_imbalance(const meshes::FieldHistory& history) {
  double worst = 0, scale = 0;
  for (const meshes::LedgerRow& row : history.ledger) {
    const double imbalance = row.stored - history.ledger.front().stored - row.infiltrated + row.outflow;
    worst = std::max(worst, std::abs(imbalance));
    scale = std::max(scale, std::abs(row.infiltrated) + std::abs(row.outflow));
  }
  return worst / scale;
}

}  // namespace wetfront::fem_reference::testing
