// Where the soil ends: inside a cell, at the border of the mesh, one cell above its base.
#include "mpm/simulation.h"
#include "verification/suites/box_mesh.h"
#include "verification/suites/hard/families.h"
#include "verification/suites/hard/hard_column.h"
#include "verification/suites/setups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

constexpr const char* by_reference = "our FEM, its mesh ending at the surface, on cells four times smaller";

/// The surface at a fraction of the top cell of forty.
HardCase fraction_row(const std::string& name, double fraction) {
  HardColumn column;
  column.rain = {{0}, {1e-4}};
  column.surface = 1.2 * (39 + fraction) / 40;
  column.outputs = {5, 450, 900};
  return column_case({.name = name,
                      .title = fmt::format("Surface at {:g} of the top cell", fraction),
                      .requirement = "Rain enters a body whose surface lies inside a cell; slivers cost no accuracy.",
                      .source = by_reference,
                      .column = column,
                      .ends = {900, 5},
                      .cells_off = 1,
                      .reason = "a front is known to a cell, wherever the surface lies"});
}

/// One cell of soil on an impermeable base: full after its deficit, then all rain runs off.
HardCase thin_cover() {
  HardColumn column;
  column.height = 0.05;
  column.cells = 1;
  column.rain = {{0}, {1e-4}};
  column.outputs = {1, 60, 600};
  HardCase row = column_case({.name = "thin_cover",
                              .title = "A cover of one cell",
                              .requirement = "5 cm of soil in one cell over rock: it fills, ponds and runs off.",
                              .source = "closed form: storage deficit, then hydrostatic from p = 0 on the surface",
                              .column = column,
                              .ends = {600, 1}});
  row.judge = [column](const mpm::Problem<2>& problem, const meshes::FieldHistory& history) {
    const double width = problem.mesh.nodes[1][0];
    const auto &first = history.ledger.front(), &last = history.ledger.back();
    std::vector<Reading> readings{
        {"delivered + run-off against asked",
         std::abs(last.stored - first.stored + last.run_off + last.outflow - last.rain_asked) / last.rain_asked,
         {1e-6, "1", "the audit of every rain boundary"}}};
    if (history.snapshots.back().time < 600) return readings;
    const double deficit = width * column.height * column.soils[0].porosity - first.stored;
    readings.push_back({"water taken against the storage deficit",
                        std::abs(last.stored - first.stored - deficit) / deficit,
                        {1e-3, "1", "full but for what 490 Pa compress: 1e-6"}});
    return readings;
  };
  return row;
}

/// The body reaches all borders of its mesh; every column of it is the same one-dimensional problem.
HardCase mesh_border() {
  HardColumn column;
  column.rain = {{0}, {1e-4}};
  column.outputs = {5, 450, 900};
  HardCase row = column_case({.name = "mesh_border",
                              .title = "Soil touching the mesh border on both sides",
                              .requirement = "Rain is not lost at corners: all columns of cells get the same.",
                              .source = "the middle of the same mesh; rain times width",
                              .column = column,
                              .ends = {900, 5}});
  row.problem = [column] {
    mpm::Problem<2> problem = strip_problem(column);
    problem.mesh = rectangle_mesh(0.3, 1.2, 5, 40);
    problem.initial_pressure.assign(problem.mesh.node_count(), -10e3);
    return problem;
  };
  row.judge = [](const mpm::Problem<2>& problem, const meshes::FieldHistory& history) {
    double apart = 0;
    const auto& p = history.snapshots.back().node_pressure;
    for (std::size_t i = 0; i < problem.mesh.node_count(); ++i)
      apart = std::max(apart, std::abs(p[i] - p[i / 6 * 6 + 3]));
    const auto &first = history.ledger.front(), &last = history.ledger.back();
    const double asked = 1e-4 * 0.3 * last.time;
    return std::vector<Reading>{
        {"pressure along rows", apart, {1e-3, "Pa", "the rows are alike to round-off of the linear solver"}},
        {"rain that came in",
         std::abs(last.stored - first.stored - asked) / asked,
         {1e-6, "1", "all of it: the rain is below ks"}}};
  };
  return row;
}

double jumps(const meshes::FieldHistory& history) {
  // Changes between running off and not: one ponding is one change.
  double changes = 0;
  bool ponded = false;
  for (std::size_t k = 1; k < history.ledger.size(); ++k) {
    const auto &a = history.ledger[k - 1], &b = history.ledger[k];
    const bool now = b.run_off - a.run_off > 1e-6 * (b.rain_asked - a.rain_asked);
    changes += now != ponded;
    ponded = now;
  }
  return changes;
}

/// Rain at just above ks on a drained column: the surface reaches p = 0 and stays there.
HardCase chatter(const std::string& name, const std::string& title, double fraction) {
  HardColumn column;
  column.height = 0.3;
  column.cells = 20;
  column.pressure = [](double) { return -3000.0; };
  column.rain = {{0}, {1.001 * 2.943e-4}};
  column.drains = true;
  if (fraction > 0) column.surface = 0.3 * (19 + fraction) / 20;
  column.outputs = {1, 900, 1200};
  HardCase row = column_case({.name = name,
                              .title = title,
                              .requirement = "Ponding that is only just reached begins once.",
                              .source = "counting; ks at the base in the steady state",
                              .column = column,
                              .ends = {1200, 1}});
  row.judge = [](const mpm::Problem<2>& problem, const meshes::FieldHistory& history) {
    std::vector<Reading> readings{
        {"changes between running off and not",
         jumps(history),
         {1, "changes", "the surface ponds once, and need not before the end of a short run"}}};
    if (history.ledger.back().time < 1200) return readings;
    const auto& last = history.ledger.back();
    const auto half = *std::find_if(history.ledger.begin(), history.ledger.end() - 1,
                                    [&](const auto& row) { return row.time >= 0.75 * last.time; });
    const double steady = 2.943e-4 * problem.mesh.nodes[1][0] * (last.time - half.time);
    readings.push_back({"drained in the last quarter",
                        std::abs(last.outflow - half.outflow - steady) / steady,
                        {1e-3, "1", "unit gradient at ks, and a thousandth more rain than that"}});
    return readings;
  };
  return row;
}

/// Largest difference between the state of a run and that of one cut in mid-ponding and continued.
double difference(const mpm::State& a, const mpm::State& b) {
  double worst = a.time == b.time && a.fields.size() == b.fields.size() ? 0 : 1;
  for (const auto& [name, values] : a.fields) {
    const auto& other = b.fields.at(name);
    for (std::size_t k = 0; k < values.size(); ++k)
      if (!(values[k] == other[k])) worst = std::max({worst, std::abs(values[k] - other[k]), 1e-300});
  }
  return worst;
}

HardCase cut() {
  HardColumn column;
  column.height = 0.1;
  column.cells = 5;
  column.soils = {{.s_min = 0.87}};
  column.pressure = [](double) { return -1000.0; };
  column.rain = {{0, 4}, {2 * 2.943e-4, 3 * 2.943e-4}};
  column.outputs = {0.5, 6, 12};
  HardCase row = column_case({.name = "cut_in_mid_ponding",
                              .title = "Cut in mid-ponding and continued",
                              .requirement = "A run cut at half of its steps goes on with the same bits.",
                              .source = "the uncut run",
                              .column = column,
                              .ends = {12, 0.5}});
  row.judge = [](mpm::Problem<2> problem, const meshes::FieldHistory& history) {
    problem.cpu_budget = 0;  // one run was within it, these are two
    const long half = static_cast<long>(history.counters.at("steps")) / 2;
    mpm::Simulation<2> whole(problem);
    for (long k = 0; k < half; ++k) whole.step();
    mpm::Simulation<2> rest(problem, whole.state());
    while (!whole.finished()) whole.step();
    while (!rest.finished()) rest.step();
    return std::vector<Reading>{
        {"difference to the uncut run", difference(whole.state(), rest.state()), {0, "-", "the same bits"}}};
  };
  return row;
}

}  // namespace

std::vector<HardCase> surface_rows() {
  return {fraction_row("surface_0_02", 0.02),
          fraction_row("surface_0_5", 0.5),
          fraction_row("surface_0_98", 0.98),
          thin_cover(),
          mesh_border(),
          chatter("barely_ponding", "Rain of 1.001 ks, drained", 0),
          chatter("barely_ponding_in_cell", "Rain of 1.001 ks, drained, surface at 0.5 of a cell", 0.5),
          cut()};
}

}  // namespace wetfront::verification
