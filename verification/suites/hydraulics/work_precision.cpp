#include "fem_reference/richards_problem.h"
#include "mpm/simulation.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
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

reports::Series climb(const ColumnWindow& window, LiquidScheme scheme, const std::vector<int>& ladder, CaseBook& book) {
  auto curve = line(scheme_name(scheme));
  for (const int cells : ladder) {
    auto problem = window.problem(cells, scheme);
    problem.stages[0].step_safety = 1;  // the largest step that its own limit allows
    problem.stages[0].time_tolerance = 1e-5;
    const auto run = book.solve(fmt::format("{}, {} cells", curve.label, cells), problem);
    put(curve, least_cpu(run.cpu_seconds, book, [&] { return mpm::run(problem).cpu_seconds; }), window.cell_error(run));
  }
  return curve;
}

reports::Series reference_curve(const ColumnWindow& window, const std::vector<int>& ladder, CaseBook& book) {
  auto curve = dashed("reference (nodes)");
  for (const int cells : ladder) {
    auto problem = window.problem(cells);
    problem.tolerance = 1e-5;
    const auto run = book.solve(fmt::format("reference, {} cells", cells), problem);
    put(curve, least_cpu(run.cpu_seconds, book, [&] { return fem_reference::solve(problem).cpu_seconds; }),
        window.node_error(run));
  }
  return curve;
}

/// CPU seconds at an error, on the straight line between neighbours in log-log; NaN beyond the runs made.
double cpu_at(const reports::Series& curve, double error) {
  for (std::size_t i = 1; i < curve.y.size(); ++i) {
    const double high = std::max(curve.y[i - 1], curve.y[i]), low = std::min(curve.y[i - 1], curve.y[i]);
    if (error > high || error < low || high == low) continue;
    const double r = std::log(error / curve.y[i - 1]) / std::log(curve.y[i] / curve.y[i - 1]);
    return curve.x[i - 1] * std::pow(curve.x[i] / curve.x[i - 1], r);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

void work(double rain, double to, int finest, CaseBook& book) {
  const ColumnWindow window({rain, 0.87}, 0.25, to, book);
  std::vector<int> few, many = {10, 20, 40, 80, 160};
  for (const int cells : {10, 20, 40})
    if (cells <= finest) few.push_back(cells);
  auto figure = figure_frame({"work_precision", "Error over CPU seconds: cells from 10 up, doubled", "Cost"},
                             {"CPU", "s"}, {"relative L2 of the pressure", "-"});
  figure.log_x = figure.log_y = true;
  figure.series = {climb(window, LiquidScheme::seepage, many, book),
                   climb(window, LiquidScheme::implicit_drag, few, book), reference_curve(window, many, book)};
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
  const double ratio = drag.x.back() / cpu_at(seepage, drag.y.back());
  book.show("cost_ratio", fmt::format("cost of implicit-drag over seepage at the error of its {} cells", few.back()),
            ratio, "times");
  figure.note = fmt::format("window of {:.0f} s of rain", window.seconds());
  book.draw(figure);
}

}  // namespace

std::vector<Case> work_precision_water_cases() {
  const std::string requirement =
      "What accuracy costs, scheme by scheme, each at the largest step its own limit allows.";
  const std::string source = "The paper's column, S_min 0.87, rain 3e-5 m/s, from 25 % of filling on.";
  return {{"work_precision", "Work and precision of the schemes", requirement, source, Effort::everyday,
           [](CaseBook& book) { work(3e-5, 0.345, 20, book); }},
          {"work_precision_fine", "Work and precision of the schemes, 40 cells too", requirement, source, Effort::heavy,
           [](CaseBook& book) { work(3e-5, 0.345, 40, book); }}};
}

}  // namespace wetfront::verification
