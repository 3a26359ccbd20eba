#include "fem_reference/richards_problem.h"
#include "mpm/plan.h"
#include "mpm/simulation.h"
#include "verification/compare/profile.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/cost_curve.h"
#include "verification/suites/hydraulics/column_window.h"
#include "verification/suites/hydraulics/families.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

using mpm::LiquidScheme;

/// The least CPU seconds of three runs where they are short enough to be disturbed.
template <class Solve>
double least_cpu(double first, CaseBook& book, const Solve& again) {
  if (first > 0.5) return first;
  for (int i = 0; i < 2; ++i) {
    const double seconds = again();
    book.spend(seconds);
    first = std::min(first, seconds);
  }
  return first;
}

/// Where schemes are compared: a problem for each, on so many cells, and the error of what comes out.
template <class Problem, class Error>
reports::Series climb(LiquidScheme scheme, const std::vector<int>& ladder, CaseBook& book, const Problem& problem_of,
                      const Error& error) {
  auto curve = line(scheme_name(scheme));
  for (const int cells : ladder) {
    mpm::Problem<2> problem = problem_of(cells, scheme);
    problem.stages[0].step_safety = 1;  // the largest step that its own limit allows
    problem.stages[0].time_tolerance = 1e-5;
    const auto run = book.solve(fmt::format("{}, {} cells", curve.label, cells), problem);
    put(curve, least_cpu(run.cpu_seconds, book, [&] { return mpm::run(problem).cpu_seconds; }), error(run));
  }
  return curve;
}

reports::Series climb(const ColumnWindow& window, LiquidScheme scheme, const std::vector<int>& ladder, CaseBook& book) {
  return climb(
      scheme, ladder, book, [&](int cells, LiquidScheme by) { return window.problem(cells, by); },
      [&](const meshes::FieldHistory& run) { return window.cell_error(run); });
}

template <class Problem, class Error>
reports::Series reference_curve(const std::vector<int>& ladder, CaseBook& book, const Problem& problem_of,
                                const Error& error) {
  auto curve = dashed("reference (nodes)");
  for (const int cells : ladder) {
    fem_reference::RichardsProblem problem = problem_of(cells);
    problem.tolerance = 1e-5;
    const auto run = book.solve(fmt::format("reference, {} cells", cells), problem);
    put(curve, least_cpu(run.cpu_seconds, book, [&] { return fem_reference::solve(problem).cpu_seconds; }), error(run));
  }
  return curve;
}

reports::Figure cost_figure(const std::string& id, const std::string& title) {
  auto figure = figure_frame({id, title, "Cost"}, {"CPU", "s"}, {"relative L2 of the pressure", "-"});
  figure.log_x = figure.log_y = true;
  return figure;
}

void work(double rain, double to, int finest, CaseBook& book) {
  const ColumnWindow window({rain, 0.87}, 0.25, to, book);
  std::vector<int> few, many = {10, 20, 40, 80, 160};
  for (const int cells : {10, 20, 40})
    if (cells <= finest) few.push_back(cells);
  auto figure = cost_figure("work_precision", "Error over CPU seconds: 10 cells and up, doubled");
  figure.series = {climb(window, LiquidScheme::seepage, many, book),
                   climb(window, LiquidScheme::implicit_drag, few, book),
                   climb(window, LiquidScheme::semi_implicit, many, book),
                   reference_curve(
                       many, book, [&](int cells) { return window.problem(cells); },
                       [&](const meshes::FieldHistory& run) { return window.node_error(run); })};
  const auto &seepage = figure.series[0], &drag = figure.series[1];
  reports::Table table{"At equal error",
                       "Cost",
                       "CPU seconds on the straight line between neighbouring runs (log-log).",
                       {"relative L2", "implicit-drag [s]", "seepage [s]", "ratio"},
                       {}};
  for (std::size_t i = 0; i < drag.x.size(); ++i) {
    const double same = cpu_at(seepage, drag.y[i]);
    table.rows.push_back({fmt::format("{:.2e}", drag.y[i]), fmt::format("{:.3f}", drag.x[i]),
                          fmt::format("{:.4f}", same), fmt::format("{:.0f}", drag.x[i] / same)});
  }
  book.tabulate(table);
  const auto literal = window.problem(finest, LiquidScheme::explicit_drag);
  book.show("explicit", fmt::format("explicit drag, {} cells: CPU seconds that its plan expects (not run)", finest),
            mpm::plan(literal).front().estimated_cpu_seconds, "s");
  const double ratio = drag.x.back() / cpu_at(seepage, drag.y.back());
  book.show("cost_ratio", fmt::format("cost of implicit-drag over seepage at the error of its {} cells", few.back()),
            ratio, "times");
  figure.note = fmt::format("window of {:.0f} s of rain", window.seconds());
  book.draw(figure);
}

/// The window in which explicit drag can be run too: 2 s on moist sand.
void work_of_all_four(CaseBook& book) {
  auto fine = moist_column(128);
  fine.tolerance = 1e-8;
  meshes::FieldHistory yardstick = book.solve("reference, 128 cells, 1e-8", fine);
  yardstick.snapshots.erase(yardstick.snapshots.begin());  // the start
  const auto error = [&](const meshes::FieldHistory& run) {
    meshes::FieldHistory end = run;
    end.snapshots = {run.snapshots.back()};
    if (run.mesh.dim == 1) {
      const auto expected = pressure_at_nodes(yardstick, run.mesh).back();
      return relative_l2(end.snapshots[0].node_pressure, expected, std::vector<double>(expected.size(), 1));
    }
    return relative_l2(end.snapshots[0].cell_pressure, profiles_at_cells(yardstick, end).back().pressure,
                       cell_weights(end.mesh, yardstick.mesh));
  };
  auto figure = cost_figure("work_precision", "Error over CPU seconds, 2 s on moist sand: 4 cells and up, doubled");
  const auto on_points_by = [](int cells, LiquidScheme scheme) { return moist_column(cells, scheme); };
  for (const auto scheme :
       {LiquidScheme::seepage, LiquidScheme::semi_implicit, LiquidScheme::implicit_drag, LiquidScheme::explicit_drag})
    figure.series.push_back(climb(scheme,
                                  scheme == LiquidScheme::explicit_drag ? std::vector{4, 8} : std::vector{4, 8, 16, 32},
                                  book, on_points_by, error));
  figure.series.push_back(reference_curve(
      {4, 8, 16, 32}, book, [](int cells) { return moist_column(cells); }, error));
  book.draw(figure);
  book.show("cost_ratio", "cost of explicit drag over seepage, both on 8 cells",
            figure.series[3].x[1] / figure.series[0].x[1], "times");
}

}  // namespace

std::vector<Case> work_precision_water_cases() {
  const std::string requirement =
      "What accuracy costs, scheme by scheme, each at the largest step its own limit allows.";
  const std::string source = "The paper's column, S_min 0.87, rain 3e-5 m/s, from 25 % of filling on.";
  return {{"work_precision", "Work and precision of the schemes", requirement, source, Effort::everyday,
           [](CaseBook& book) { work(3e-5, 0.345, 20, book); }},
          {"work_precision_moist", "Work and precision of all four schemes, 2 s on moist sand", requirement,
           "The paper's sand, 0.3 m, hydrostatic, rain 1.5e-4 m/s.", Effort::everyday, work_of_all_four},
          {"work_precision_fine", "Work and precision of the schemes, 40 cells too", requirement, source, Effort::heavy,
           [](CaseBook& book) { work(3e-5, 0.345, 40, book); }}};
}

}  // namespace wetfront::verification
