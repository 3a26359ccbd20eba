#pragma once

#include "mpm/problem.h"

#include <algorithm>
#include <cmath>
#include <utility>

/// Hand-made strips of cells and the soils of benchmarks.md, for the tests of mpm/.
namespace wetfront::mpm::test {

/// A column one cell wide: nodes 2k (left) and 2k+1 (right) at height k h, cells from the base upwards.
inline meshes::Mesh strip(double height, int cells) {
  meshes::Mesh mesh;
  const double h = height / cells;
  for (int k = 0; k <= cells; ++k)
    for (int side = 0; side < 2; ++side) mesh.nodes.push_back({side * h, k == cells ? height : k * h, 0});
  meshes::Side left{"left", {}}, right{"right", {}};
  for (int k = 0; k < cells; ++k) {
    for (int node : {2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2}) mesh.cells.push_back(node);
    mesh.region.push_back(0);
    for (int node : {2 * k + 2, 2 * k}) left.faces.push_back(node);
    for (int node : {2 * k + 1, 2 * k + 3}) right.faces.push_back(node);
  }
  mesh.region_names = {"soil"};
  mesh.sides = {{"base", {0, 1}}, {"top", {2 * cells, 2 * cells + 1}}, left, right};
  return mesh;
}

/// The same column in three dimensions: nodes 4k .. 4k+3 counter-clockwise at height k h.
inline meshes::Mesh pillar(double height, int cells) {
  meshes::Mesh mesh;
  mesh.dim = 3;
  const double h = height / cells;
  for (int k = 0; k <= cells; ++k)
    for (const auto& [x, y] : {std::pair{0., 0.}, {h, 0.}, {h, h}, {0., h}})
      mesh.nodes.push_back({x, y, k == cells ? height : k * h});
  for (int k = 0; k < cells; ++k) {
    for (int i = 0; i < 8; ++i) mesh.cells.push_back(4 * k + i);
    mesh.region.push_back(0);
  }
  mesh.region_names = {"soil"};
  mesh.sides = {{"base", {0, 1, 2, 3}}, {"top", {4 * cells, 4 * cells + 1, 4 * cells + 2, 4 * cells + 3}}};
  return mesh;
}

/// The seed paper's sand (Table 1), lambda and p0 with either S_min.
inline Soil seed_sand(double s_min) {
  Soil soil;
  soil.name = "sand";
  soil.porosity = 0.46;
  soil.grain_density = 2690;
  soil.intrinsic_permeability = 3e-11;
  soil.retention = VanGenuchtenRetention{4350, 0.61, s_min, 1.0};
  soil.permeability = MualemPermeability{};
  soil.origin = "test:soil";
  return soil;
}

inline Water seed_water() {
  return {1000, 0.2e9, 1e-3, "test:water"};
}

/// Seconds until rain fills the storage deficit of a column, from its initial nodal pressures (trapezoidal sum).
inline double filling_time(const Problem<2>& problem, double intensity) {
  const auto& spec = std::get<VanGenuchtenRetention>(*problem.soils[0].retention);
  const auto missing = [&](double p) {
    const double s = std::max(0.0, -p);
    return problem.soils[0].porosity * (spec.s_max - spec.s_min) *
           (1 - std::pow(1 + std::pow(s / spec.air_entry, 1 / (1 - spec.lambda)), -spec.lambda));
  };
  double deficit = 0;
  for (std::size_t i = 2; i < problem.mesh.node_count(); i += 2)
    deficit += 0.5 * (problem.mesh.nodes[i][1] - problem.mesh.nodes[i - 2][1]) *
               (missing(problem.initial_pressure[i]) + missing(problem.initial_pressure[i - 2]));
  return deficit / intensity;
}

/// 1.2 m of sand over an impermeable base, suction hydrostatic from the base and capped at 10 kPa, rain on top.
inline Problem<2> seed_column(int cells, double s_min, double intensity, double end_time) {
  Problem<2> problem;
  problem.mesh = strip(1.2, cells);
  problem.gravity = {0, -9.81};
  problem.gravity_origin = "test:gravity";
  problem.water = seed_water();
  problem.soils = {seed_sand(s_min)};
  for (const auto& node : problem.mesh.nodes) problem.initial_pressure.push_back(-std::min(9810.0 * node[1], 10e3));
  problem.water_boundary = {RainSide{"top", {{0.0}, {intensity}}, "test:rain"}};
  problem.points_per_cell = 4;
  Stage stage;
  stage.name = "infiltration";
  stage.liquid = LiquidScheme::seepage;
  stage.end_time = end_time;
  stage.origin = "test:stage";
  problem.stages = {stage};
  return problem;
}

}  // namespace wetfront::mpm::test
