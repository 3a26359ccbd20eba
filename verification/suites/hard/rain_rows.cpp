// Rain weak and strong, on and off, none at all, in long records; evaporation; ponding held from outside.
#include "verification/suites/hard/families.h"
#include "verification/suites/hard/hard_column.h"
#include "verification/suites/setups.h"

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

constexpr const char* by_reference = "our FEM on cells four times smaller";
constexpr const char* one_cell = "a front is known to a cell; the yardstick's cells are four times smaller";
constexpr double ks = 2.943e-4;

HardCase ratio_row(const std::string& name, const std::string& title, double ratio) {
  HardColumn column;
  column.rain = {{0}, {ratio * ks}};
  const double filling = 0.2 / std::min(ratio * ks, ks);  // 0.2 m of water, less what runs off
  column.outputs = {1e-3 * filling, 0.5 * filling, filling};
  return column_case({.name = name,
                      .title = title,
                      .requirement = "Rain from a tenth to ten times what the saturated soil conducts.",
                      .source = by_reference,
                      .column = column,
                      .ends = {filling, 1e-3 * filling},
                      .seepage_until = 0.5 * filling,
                      .cells_off = 1,
                      .reason = one_cell});
}

/// Two minutes of rain at twice ks, two minutes of none, thirty times, over a drain: S crosses 1 sixty times.
HardColumn on_and_off() {
  HardColumn column;
  column.height = 0.3;
  column.cells = 20;
  column.pressure = [](double) { return -3000.0; };
  column.drains = true;
  for (int k = 0; k < 30; ++k)
    for (const bool raining : {true, false}) {
      column.rain.start.push_back(240.0 * k + (raining ? 0 : 120));
      column.rain.intensity.push_back(raining ? 2 * ks : 0.0);
    }
  column.outputs = {2, 3600, 7200};
  return column;
}

/// A record of `rows` ten-minute sums such as rain gauges leave: mostly dry, storms now and then. Deterministic.
HardColumn long_record(int rows) {
  HardColumn column;
  column.height = 1;
  column.cells = 10;
  column.drains = true;
  column.soils = {{.ks = 1e-5, .porosity = 0.4, .air_entry = 5000, .n = 2, .s_min = 0.1}};
  column.pressure = [](double) { return -8000.0; };
  unsigned state = 1;
  for (int k = 0; k < rows; ++k) {
    state = 1664525U * state + 1013904223U;
    const double draw = state / 4294967296.0;
    column.rain.start.push_back(600.0 * k);
    column.rain.intensity.push_back(draw < 0.9 ? 0 : 1e-6 * std::exp(6 * (draw - 0.9) / 0.1 - 3));
  }
  column.outputs = {600, 300.0 * rows, 600.0 * rows};
  return column;
}

HardCase record_row(const std::string& name, int rows, Effort effort, double budget) {
  return column_case({.name = name,
                      .title = "Rain record of " + std::to_string(rows) + " rows",
                      .requirement = "Every row is stepped onto; none is lost and none costs more than a few steps.",
                      .source = by_reference,
                      .effort = effort,
                      .column = long_record(rows),
                      .ends = {600.0 * rows, 600},
                      .budget = budget,
                      .cells_off = 1,
                      .reason = one_cell,
                      .finer = 1});
}

HardColumn drying() {
  HardColumn column;
  column.evaporation = {{0}, {1e-7}};
  column.rain = {{0}, {0}};
  column.least_pressure = -1e6;
  column.soils = {{.ks = 1e-6, .porosity = 0.4, .air_entry = 8000, .n = 1.6, .s_min = 0.1}};
  column.pressure = [](double z) { return -9810 * z; };
  column.outputs = {600, 10 * day, 20 * day};
  return column;
}

HardCase drizzle() {
  HardColumn column;
  column.pressure = [](double z) { return -9810 * z; };
  column.rain = {{0}, {1e-12}};
  column.outputs = {1, 3600};
  HardCase row = column_case({.name = "drizzle",
                              .title = "Drizzle of 1e-12 m/s",
                              .requirement = "Rain far below the tolerance of Newton's method per step is not lost.",
                              .source = "the rain record: 3.6 nm of water",
                              .column = column,
                              .ends = {3600, 1}});
  row.windows = {};  // in a second there falls less than the round-off of what is stored
  row.judge = [](const mpm::Problem<2>&, const meshes::FieldHistory& history) {
    const auto &first = history.ledger.front(), &last = history.ledger.back();
    return std::vector<Reading>{
        {"rain found in storage",
         std::abs(last.stored - first.stored - last.rain_asked) / last.rain_asked,
         {1e-2, "1", "round-off of the stored water is 1e-16 of it, the rain 1e-8 of it; Newton closes to 1e-12"}}};
  };
  return row;
}

HardColumn held_pond() {
  HardColumn column;
  column.pressure = [](double) { return -100e3; };
  column.top_pressure = 5000;
  column.outputs = {1, 150, 300};
  return column;
}

/// Hydrostatic, no rain: nothing may move, for a day.
HardCase zero_rain(const std::string& name, const std::string& title, double cap) {
  HardColumn column;
  column.height = 1;
  column.pressure = [cap](double z) { return -std::min(9810 * z, cap); };
  column.rain = {{0}, {0}};
  column.outputs = {10, 1 * day};
  HardCase row = column_case({.name = name,
                              .title = title,
                              .requirement = "A day without rain.",
                              .source = by_reference,
                              .column = column,
                              .ends = {1 * day, 10},
                              .cells_off = 1,
                              .reason = one_cell});
  if (cap < 9810) return row;
  // From the start itself: after seepage two velocities stand off hydrostatic at first (two_velocity/README.md section
  // 4).
  row.window_from = 0;
  row.source = "the hydrostatic state itself";
  row.judge = [](const mpm::Problem<2>& problem, const meshes::FieldHistory& history) {
    double worst = 0;
    for (std::size_t i = 0; i < problem.mesh.node_count(); ++i)
      worst = std::max(worst, std::abs(history.snapshots.back().node_pressure[i] - problem.initial_pressure[i]));
    return std::vector<Reading>{{"pressure moved", worst, {1, "Pa", "the static test of physics.md: 1 Pa"}}};
  };
  return row;
}

}  // namespace

std::vector<HardCase> rain_rows() {
  return {ratio_row("rain_0_1_ks", "Rain of 0.1 ks", 0.1),
          ratio_row("rain_1_ks", "Rain of exactly ks", 1),
          ratio_row("rain_10_ks", "Rain of 10 ks", 10),
          column_case({.name = "rain_on_off",
                       .title = "Rain on and off, S through 1 sixty times",
                       .requirement = "Ponding and draining alternate every two minutes.",
                       .source = by_reference,
                       .column = on_and_off(),
                       .ends = {7200, 2},
                       .cells_off = 1,
                       .reason = one_cell}),
          record_row("record_1e3_rows", 1000, Effort::quick, 4),
          record_row("record_1e4_rows", 10000, Effort::heavy, 60),
          record_row("record_1e5_rows", 100000, Effort::heavy, 600),
          zero_rain("zero_rain_hydrostatic", "No rain for a day, hydrostatic", 1e9),
          zero_rain("zero_rain_capped", "No rain for a day, suction capped at 5 kPa", 5e3),
          drizzle(),
          column_case({.name = "evaporation_to_limit",
                       .title = "Evaporation down to -1 MPa at the surface",
                       .requirement = "Demand is met in full, then in part: the surface stops at its least pressure.",
                       .source = by_reference,
                       .column = drying(),
                       .ends = {20 * day, 600},
                       .cells_off = 1,
                       .reason = "drying from the surface is known to a cell"}),
          column_case({.name = "held_pond_on_dry_sand",
                       .title = "A pond of 0.5 m on sand at -100 kPa",
                       .requirement = "Pressure jumps by 105 kPa across the first cell.",
                       .source = by_reference,
                       .column = held_pond(),
                       .ends = {300, 1},
                       .cells_off = 1,
                       .reason = one_cell})};
}

}  // namespace wetfront::verification
