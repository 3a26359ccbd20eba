#include "verification/suites/hydraulics/column_window.h"

#include "meshes/evaluate.h"
#include "verification/compare/profile.h"
#include "verification/suites/on_points.h"
#include "verification/suites/setups.h"

namespace wetfront::verification {

ColumnWindow::ColumnWindow(const SeedColumn& column, double from, double to, CaseBook& book)
    : column_(column), seconds_((to - from) * column.filling_time()) {
  auto problem = column.problem(640, {from, to});
  problem.tolerance = 1e-7;
  yardstick_ = book.solve("reference, 640 cells", problem);
}

fem_reference::RichardsProblem ColumnWindow::problem(int cells) const {
  auto problem = column_.problem(cells, {1});
  problem.output_times = {seconds_};
  problem.end_time = seconds_;
  const meshes::Evaluator evaluate(yardstick_.mesh);
  start_from(problem, [&](const meshes::Point& at) {
    return evaluate(yardstick_.snapshots.front().node_pressure, at) / problem.unit_weight;
  });
  return problem;
}

mpm::Problem<2> ColumnWindow::problem(int cells, mpm::LiquidScheme scheme) const {
  mpm::Problem<2> out = on_points(problem(cells));
  out.stages[0].liquid = scheme;
  out.stages[0].name = scheme_name(scheme);
  return out;
}

double ColumnWindow::cell_error(const meshes::FieldHistory& history) const {
  meshes::FieldHistory end = yardstick_;
  end.snapshots = {yardstick_.snapshots.back()};
  return relative_l2(cell_profiles(history).back().pressure, profiles_at_cells(end, history).back().pressure,
                     cell_weights(history.mesh, end.mesh));
}

double ColumnWindow::node_error(const meshes::FieldHistory& history) const {
  const auto expected = pressure_at_nodes(yardstick_, history.mesh).back();
  return relative_l2(history.snapshots.back().node_pressure, expected, std::vector<double>(expected.size(), 1));
}

fem_reference::RichardsProblem moist_column(int cells) {
  auto problem = SeedColumn{1.5e-4}.problem(cells, {1});
  for (auto& node : problem.mesh.nodes) node[0] *= 0.25;
  start_from(problem, [](const meshes::Point& at) { return -at[0]; });
  problem.gauges.clear();
  problem.output_times = {0, 2};
  problem.end_time = 2;
  return problem;
}

mpm::Problem<2> moist_column(int cells, mpm::LiquidScheme scheme) {
  mpm::Problem<2> problem = on_points(moist_column(cells));
  problem.stages[0].liquid = scheme;
  return problem;
}

std::string scheme_name(mpm::LiquidScheme scheme) {
  switch (scheme) {
    case mpm::LiquidScheme::seepage:
      return "seepage";
    case mpm::LiquidScheme::semi_implicit:
      return "semi-implicit";
    case mpm::LiquidScheme::implicit_drag:
      return "implicit-drag";
    case mpm::LiquidScheme::explicit_drag:
      break;
  }
  return "explicit";
}

}  // namespace wetfront::verification
