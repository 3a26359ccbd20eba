// Stiff and incompressible water, closed boxes, starts above zero pressure, next to no pores.
#include "verification/suites/box_mesh.h"
#include "verification/suites/hard/families.h"
#include "verification/suites/hard/hard_column.h"
#include "verification/suites/setups.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

constexpr const char* by_reference = "our FEM on cells four times smaller";
constexpr double weight = 9810, infinite = std::numeric_limits<double>::infinity();

/// The column fills from its base to its surface, ponds, and stays full.
HardCase filling_row(const std::string& name, const std::string& title, double bulk_modulus) {
  HardColumn column;
  column.soils = {{.s_min = 0.5}};
  column.pressure = [](double z) { return -std::min(weight * z, 10e3); };
  column.rain = {{0}, {2e-4}};
  column.bulk_modulus = bulk_modulus;
  column.outputs = {1, 600, 1500};
  return column_case({.name = name,
                      .title = title,
                      .requirement = "A closed column fills, ponds and rests; pressure waves are stiff.",
                      .source = by_reference,
                      .column = column,
                      .ends = {1500, 1},
                      .cells_off = 1,
                      .reason = "full columns hold the same water; until then a front is known to a cell"});
}

/// A closed square box, all water, cells skewed; `pressure` at the start.
mpm::Problem<2> box(const std::function<double(double)>& pressure, double bulk_modulus) {
  HardColumn column;
  column.height = 1;
  column.bulk_modulus = bulk_modulus;
  column.outputs = {0.1, 1, 3600};
  mpm::Problem<2> problem = strip_problem(column);
  problem.mesh = rectangle_mesh(1, 1, 10, 10);
  for (auto& node : problem.mesh.nodes) {
    const double x = node[0], y = node[1];
    node[0] += 0.05 * std::sin(M_PI * x) * std::sin(2 * M_PI * y);
    node[1] += 0.05 * std::sin(2 * M_PI * x) * std::sin(M_PI * y);
  }
  problem.initial_pressure.clear();
  for (const auto& node : problem.mesh.nodes) problem.initial_pressure.push_back(pressure(node[1]));
  return problem;
}

/// Largest distance from a hydrostatic state of the mean pressure at half height.
std::vector<Reading> hydrostatic(const meshes::FieldHistory& history, double middle, double bound,
                                 const std::string& reason) {
  double worst = 0;
  const auto& shot = history.snapshots.back();
  for (std::size_t i = 0; i < history.mesh.node_count(); ++i) {
    const double error = std::abs(shot.node_pressure[i] - middle - weight * (0.5 - history.mesh.nodes[i][1]));
    worst = error <= worst ? worst : error;
  }
  return {{"distance from hydrostatic", worst, {bound, "Pa", reason}}};
}

HardCase box_row(const std::string& name, const std::string& title, double slope, double bulk_modulus) {
  HardCase row;
  row.name = name;
  row.title = title;
  row.requirement = "Equal-order interpolation must neither oscillate nor drift where water cannot leave.";
  row.source = "closed form: the mean pressure stays, the rest becomes hydrostatic";
  row.problem = [=] { return box([=](double z) { return 50e3 + slope * weight * (0.5 - z); }, bulk_modulus); };
  row.ends = {3600, 1, 0.1};  // pressures even out within 0.1 s: (1 m)^2 over their diffusivity is 7 ms
  row.undetermined = std::isinf(bulk_modulus);  // any constant may be added to its pressure
  row.judge = [](const mpm::Problem<2>&, const meshes::FieldHistory& history) {
    return hydrostatic(history, 50e3, 1, "at rest: the static test of physics.md, 1 Pa");
  };
  return row;
}

HardCase wet_start() {
  HardColumn column;
  column.height = 1;
  column.pressure = [](double z) { return weight * (1.5 - z); };  // artesian: 4.9 kPa at the surface
  column.rain = {{0}, {1e-5}};
  column.outputs = {1, 60};
  HardCase row = column_case({.name = "start_above_zero",
                              .title = "Start at 4.9 kPa on the rained surface",
                              .requirement = "What is too much leaves at once; rain runs off; nothing oscillates.",
                              .source = "closed form: hydrostatic from p = 0 on the surface",
                              .column = column,
                              .ends = {60, 1}});
  row.judge = [](const mpm::Problem<2>&, const meshes::FieldHistory& history) {
    return hydrostatic(history, 0.5 * weight, 1, "at rest: the static test of physics.md, 1 Pa");
  };
  return row;
}

HardCase few_pores() {
  HardColumn column;
  column.soils = {{.porosity = 0.001}};
  column.rain = {{0}, {1e-6}};
  column.outputs = {1, 200, 400};
  return column_case({.name = "porosity_0_001",
                      .title = "Porosity 0.001",
                      .requirement = "A thousandth of the volume takes the water: fractured rock as a continuum.",
                      .source = by_reference,
                      .column = column,
                      .ends = {400, 1},
                      .seepage_until = 200,
                      .cells_off = 1,
                      .reason = "a front is known to a cell"});
}

HardCase rising_table() {
  HardColumn column;
  column.pressure = [](double) { return -10e3; };
  column.base_pressure = 8000;
  column.outputs = {1, 1800, 3600};
  return column_case({.name = "water_from_below",
                      .title = "A head of 0.8 m at the base of dry sand",
                      .requirement = "Water rises; p > 0 below, suction above, nothing at the top.",
                      .source = by_reference,
                      .column = column,
                      .ends = {3600, 1},
                      .cells_off = 1,
                      .reason = "a front is known to a cell"});
}

}  // namespace

std::vector<HardCase> water_rows() {
  return {
      filling_row("water_0_2_gpa", "Filling with K_l = 0.2 GPa", 0.2e9),
      filling_row("water_2_15_gpa", "Filling with K_l = 2.15 GPa", 2.15e9),
      filling_row("water_incompressible", "Filling with incompressible water", infinite),
      box_row("closed_box_at_rest", "Closed saturated box, hydrostatic", 1, 2.15e9),
      box_row("closed_box_to_rest", "Closed saturated box, uniform pressure at the start", 0, 2.15e9),
      box_row("closed_box_incompressible", "Closed saturated box of incompressible water, hydrostatic", 1, infinite),
      wet_start(),
      few_pores(),
      rising_table()};
}

}  // namespace wetfront::verification
