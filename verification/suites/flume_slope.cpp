#include "verification/suites/flume_slope.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

constexpr double thickness = 1.2, unit_weight = 9810, suction_cap = 10e3 / unit_weight;  // m, Pa/m, m

struct Segment {
  double length, degrees;
};
constexpr std::array segments{Segment{6, 0}, Segment{6, 10}, Segment{10, 30}, Segment{1, 0}};

/// `cells` + 1 base points: every kink is one, the rest spread evenly over the segments by horizontal length.
std::vector<meshes::Point> base_points(int cells) {
  double extent = 0;
  for (const auto& [length, degrees] : segments) extent += length * std::cos(degrees * std::numbers::pi / 180);
  std::vector<meshes::Point> points{{0, 0, 0}};
  double x = 0, y = 0;
  for (const auto& [length, degrees] : segments) {
    const double angle = degrees * std::numbers::pi / 180;
    const double dx = length * std::cos(angle), dy = length * std::sin(angle);
    const int first = static_cast<int>(std::lround(cells * x / extent));
    const int count = static_cast<int>(std::lround(cells * (x + dx) / extent)) - first;
    for (int i = 1; i <= count; ++i) points.push_back({x + dx * i / count, y + dy * i / count, 0});
    x += dx;
    y += dy;
  }
  return points;
}

meshes::Mesh layer_mesh(const std::vector<meshes::Point>& base, int cells_over) {
  meshes::Mesh mesh;
  mesh.dim = 2;
  const int along = static_cast<int>(base.size()) - 1, row = cells_over + 1;
  mesh.sides = {{"base", {}}, {"top", {}}, {"left", {}}, {"right", {}}};
  for (const meshes::Point& point : base) {
    for (int j = 0; j <= cells_over; ++j) mesh.nodes.push_back({point[0], point[1] + thickness * j / cells_over, 0});
  }
  const auto add = [](meshes::Side& side, int a, int b) { side.faces.insert(side.faces.end(), {a, b}); };
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < cells_over; ++j) {
      const int a = i * row + j;
      mesh.cells.insert(mesh.cells.end(), {a, a + row, a + row + 1, a + 1});
    }
    add(mesh.sides[0], i * row, (i + 1) * row);
    add(mesh.sides[1], i * row + cells_over, (i + 1) * row + cells_over);
  }
  for (int j = 0; j < cells_over; ++j) {
    add(mesh.sides[2], j, j + 1);
    add(mesh.sides[3], along * row + j, along * row + j + 1);
  }
  mesh.region.assign(static_cast<std::size_t>(along) * cells_over, 0);
  mesh.region_names = {"sand"};
  return mesh;
}

/// The seed paper's Table 1: p0 = 4.35 kPa, lambda = 0.61, n = 0.46, S_min = 0.087, k = 3e-11 m2, K_w = 0.2 GPa.
fem::Soil sand() {
  constexpr double porosity = 0.46;
  fem::Soil soil;
  soil.name = "sand";
  soil.retention = fem::VanGenuchten{porosity * 0.087, porosity, unit_weight / 4350, 1 / (1 - 0.61)};
  soil.conductivity = fem::MualemConductivity{};
  soil.saturated_conductivity = 3e-11 * unit_weight / 1e-3;
  soil.specific_storage = porosity * unit_weight / 0.2e9;
  soil.porosity = porosity;
  return soil;
}

}  // namespace

fem::RichardsProblem flume_slope(int cells_along, int cells_over) {
  fem::RichardsProblem problem;
  problem.mesh = layer_mesh(base_points(cells_along), cells_over);
  problem.gravity_direction = {0, -1, 0};
  problem.unit_weight = unit_weight;
  problem.soils = {sand()};
  problem.boundary = {fem::RainSide{"top", {{0}, {3e-5}}}, fem::RainSide{"left", {}}};
  for (const meshes::Point& node : problem.mesh.nodes) problem.initial_head.push_back(std::max(-node[1], -suction_cap));
  problem.end_time = 9267;
  problem.output_times = {3000, 6000, 9267};
  problem.tolerance = 1e-3;
  return problem;
}

}  // namespace wetfront::verification
