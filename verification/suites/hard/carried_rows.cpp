// Blocks that slide over a smooth base, through many cells, while water moves in them: rained on, ponded, very dry,
// full of stiff water. What moves a column of points sideways changes nothing in it, so its middle is held against the
// reference's column at rest.
#include "verification/suites/box_mesh.h"
#include "verification/suites/hard/families.h"
#include "verification/suites/hard/hard_column.h"
#include "verification/suites/mechanics/motion_setups.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace wetfront::verification {
namespace {

constexpr int across = 5, over = 10;  ///< cells of the block
constexpr int first = 2, way = 8;     ///< cells before it and cells that it passes
constexpr int along = first + across + way + 2;
constexpr double h = 0.03;

struct CarriedRow {
  std::string name, title, requirement;
  HardColumn column;   ///< its last output ends the way
  double young = 3e6;  ///< Pa
  /// Horizontal over vertical effective stress at the start: what suction needs at the free sides (1), or weight (0).
  double earth_pressure = 0;
  bool weightless = false;
  double cells_off = 1;   ///< bound on misplaced_water [cells]
  double pressure_off{};  ///< Pa, in place of it where nothing may move
  std::string reason;
};

HardColumn gravel(double suction) {
  HardColumn column;
  column.height = over * h;
  column.cells = over;
  column.soils = {{.ks = 0.05, .air_entry = 1000}};
  column.pressure = [suction](double) { return -suction; };
  column.rain = {{0}, {0.02}};
  column.outputs = {1};
  return column;
}

/// Nothing but its base holds the block; nu = 0, so that its weight does not press sideways. Above it there is a row of
/// empty cells, for its surface is to move with it.
mpm::Problem<2> sliding_block(const CarriedRow& row) {
  const HardColumn& column = row.column;
  mpm::Problem<2> problem = strip_problem(column);
  const double end = column.outputs.back();
  problem.mesh = rectangle_mesh(along * h, (over + 1) * h, along, over + 1);
  std::vector<std::string> names;
  for (const mpm::Soil& soil : problem.soils) names.push_back(soil.name);
  name_regions(problem.mesh, names, [&](const meshes::Point& at) { return static_cast<int>(column.soil_at(at[1])); });
  fill_only<2>(problem, [](const meshes::Point& at) {
    return at[0] > first * h && at[0] < (first + across) * h && at[1] < over * h;
  });
  for (auto& boundary : problem.water_boundary) std::get<mpm::RainSide>(boundary).side = mpm::free_surface;
  problem.initial_pressure.clear();
  for (const auto& node : problem.mesh.nodes) problem.initial_pressure.push_back(column.pressure(node[1]));
  for (mpm::Soil& soil : problem.soils) {
    soil.elastic = mpm::Elastic{row.young, 0, "row: skeleton"};
    soil.earth_pressure_at_rest = row.earth_pressure;
  }
  problem.initial_stress = mpm::InitialStress::k0;
  if (row.weightless) problem.gravity = {0, -1e-12};  // says where up is; pulls at nothing
  problem.fixities = {{"base", {false, true, false}, "row: skeleton"}};
  problem.initial_velocity = [end](const std::array<double, 2>&) { return std::array{way * h / end, 0.0}; };
  return problem;
}

/// The cells in the middle of the block as they are recorded, as a strip at rest.
meshes::FieldHistory middle_of(const HardColumn& column, const meshes::FieldHistory& history) {
  meshes::FieldHistory strip;
  strip.mesh = strip_problem(column).mesh;
  for (const meshes::Snapshot& shot : history.snapshots) {
    meshes::Snapshot& out = strip.snapshots.emplace_back();
    out.time = shot.time;
    out.cells_hold_averages = shot.cells_hold_averages;
    const double passed = way * shot.time / column.outputs.back();
    const auto at = static_cast<std::size_t>(first + across / 2.0 + passed);
    for (std::size_t level = 0; level <= over; ++level) {
      for (const std::size_t side : {0, 1})
        out.node_pressure.push_back(shot.node_pressure[level * (along + 1) + at + side]);
      if (level < over) out.cell_pressure.push_back(shot.cell_pressure[level * along + at]);
    }
  }
  return strip;
}

double largest_change(const meshes::FieldHistory& strip) {
  const auto &first_shot = strip.snapshots.front(), &last = strip.snapshots.back();
  double worst = 0;
  for (std::size_t i = 0; i < last.node_pressure.size(); ++i) {
    const double change = std::abs(last.node_pressure[i] - first_shot.node_pressure[i]);
    worst = change <= worst ? worst : change;
  }
  return worst;
}

HardCase carried(const CarriedRow& row) {
  HardCase out;
  out.name = row.name, out.title = row.title, out.requirement = row.requirement;
  out.source = "our FEM of the column at rest, on cells four times smaller";
  out.problem = [row] { return sliding_block(row); };
  out.ends = {row.column.outputs.rbegin(), row.column.outputs.rend()};
  out.carried = true;
  out.budget = 12;
  const auto reference = std::make_shared<std::optional<meshes::FieldHistory>>();
  out.judge = [row, reference](const mpm::Problem<2>&, const meshes::FieldHistory& history) {
    const meshes::FieldHistory middle = middle_of(row.column, history);
    if (row.pressure_off > 0)
      return std::vector<Reading>{
          {"pressure moved in the middle", largest_change(middle), {row.pressure_off, "Pa", row.reason}}};
    if (!*reference) *reference = fem_reference::solve(line_problem(row.column, 4));
    return std::vector<Reading>{{"misplaced water in the middle",
                                 misplaced_water(row.column, middle, **reference),
                                 {row.cells_off, "cells", row.reason}}};
  };
  return out;
}

}  // namespace

std::vector<HardCase> carried_rows() {
  const std::string one_cell = "a front is known to a cell";
  HardColumn dry = gravel(100e3), ponded = gravel(10e3), on_off = gravel(10e3), full = gravel(0), clay = gravel(0),
             layers = gravel(5e3);
  ponded.rain = {{0}, {0.1}};
  on_off.rain = {{0, 0.2, 0.4, 0.6, 0.8}, {0.1, 0, 0.1, 0, 0.1}};
  full.bulk_modulus = 2.15e9;
  full.soils = {{.ks = 1e-6, .air_entry = 100e3}};
  full.pressure = [](double) { return -3e3; };
  full.rain = {};
  full.outputs = {0.1};
  clay.soils = {{.ks = 1e-7, .porosity = 0.45, .air_entry = 9810, .n = 1.1, .s_min = 0.15, .cut_off = 100}};
  clay.pressure = [](double z) { return z > 5.5 * h ? -100.0 : -100e3; };
  clay.rain = {{0}, {1e-6}};
  layers.soils = {{.ks = 0.05, .air_entry = 1000}, {.ks = 5e-5, .air_entry = 4000}};
  layers.soil_at = [](double z) { return z > 5 * h ? 0 : 1; };
  layers.rain = {{0}, {0.04}};
  return {carried({.name = "carried_front",
                   .title = "Carried over 8 cells: a front",
                   .requirement = "Rain enters dry gravel that slides through cells.",
                   .column = gravel(10e3),
                   .reason = one_cell}),
          carried({.name = "carried_dry",
                   .title = "Carried over 8 cells: a front into -100 kPa",
                   .requirement = "Rain enters gravel that conducts nothing while it slides through cells.",
                   .column = dry,
                   .young = 100e6,
                   .earth_pressure = 1,
                   .reason = one_cell}),
          carried({.name = "carried_ponded",
                   .title = "Carried over 8 cells: filling and ponded",
                   .requirement = "Twice what the soil conducts: ponding while points cross cells.",
                   .column = ponded,
                   .reason = one_cell}),
          carried({.name = "carried_on_off",
                   .title = "Carried over 8 cells: rain on and off",
                   .requirement = "The surface goes in and out of ponding while points cross cells.",
                   .column = on_off,
                   .reason = one_cell}),
          carried({.name = "carried_full",
                   .title = "Carried over 8 cells: full of stiff water",
                   .requirement = "Water of 2.15 GPa at rest in a body that moves stays at rest.",
                   .column = full,
                   .earth_pressure = 1,
                   .weightless = true,
                   .pressure_off = 30,
                   .reason = "a hundredth of the suction that everything is in balance with"}),
          carried({.name = "carried_clay",
                   .title = "Carried over 8 cells: a step of 100 kPa in clay",
                   .requirement = "What cannot flow within the time has to stay where it is.",
                   .column = clay,
                   .young = 100e6,
                   .earth_pressure = 1,
                   .reason = one_cell}),
          carried({.name = "carried_layers",
                   .title = "Carried over 8 cells: coarse over fine, contrast 1e3",
                   .requirement = "Water perches on the fine layer of a block that slides.",
                   .column = layers,
                   .reason = one_cell})};
}

}  // namespace wetfront::verification
