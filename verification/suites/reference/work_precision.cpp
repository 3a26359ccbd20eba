#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/closed_form_case.h"
#include "verification/suites/cost_curve.h"
#include "verification/suites/reference/celia_problem.h"
#include "verification/suites/reference/families.h"
#include "verification/suites/reference/integrators.h"
#include "verification/suites/reference/srivastava_yeh_problem.h"
#include "verification/suites/series.h"
#include "verification/suites/setups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

struct WorkCase {
  std::function<fem::RichardsProblem(int cells)> problem;
  int cells;                ///< of the mesh on which integrators are compared
  std::vector<int> meshes;  ///< over which mesh and tolerance vary together
  int finest;               ///< mesh of the yardstick of the second figure
  int repeats;              ///< of each run; the least CPU time counts
};

/// Largest rms difference of the head over the output times [m], on the nodes of `a`, which are among those of `b`
/// (columns only).
double difference(const meshes::FieldHistory& a, const meshes::FieldHistory& b) {
  const std::size_t stride = b.mesh.cell_count() / a.mesh.cell_count();
  double worst = 0;
  for (std::size_t t = 0; t < b.snapshots.size(); ++t) {
    const auto p = heads_of(a.snapshots[t]), q = heads_of(b.snapshots[t]);
    double squares = 0;
    for (std::size_t i = 0; i < p.size(); ++i) squares += std::pow(p[i] - q[i * stride], 2);
    worst = std::max(worst, std::sqrt(squares / p.size()));
  }
  return worst;
}

struct Point {
  double cpu, error, steps;
};

Point run(const WorkCase& in, int cells, fem::Integrator integrator, double tolerance,
          const meshes::FieldHistory& yardstick, CaseBook& book) {
  fem::RichardsProblem problem = in.problem(cells);
  problem.integrator = integrator;
  problem.tolerance = tolerance;
  auto history = book.solve(fmt::format("{}, {} cells, {:g}", integrator_name(integrator), cells, tolerance), problem);
  Point point{history.cpu_seconds, difference(history, yardstick), history.counters.at("steps")};
  for (int i = 1; i < in.repeats; ++i) {
    const double again = fem::solve(problem).cpu_seconds;
    book.spend(again);
    point.cpu = std::min(point.cpu, again);
  }
  return point;
}

reports::Figure log_figure(const FigureHeading& heading) {
  reports::Figure figure = figure_frame(heading, {"CPU", "s"}, {"rms error of the head", "m"});
  figure.log_x = figure.log_y = true;
  return figure;
}

std::string seconds_text(double seconds) {
  return std::isnan(seconds) ? "not reached" : fmt::format("{:.4f}", seconds);
}

/// At equal error: every integrator's CPU seconds, and the best one's beside backward Euler's.
void compare(const std::vector<reports::Series>& curves, CaseBook& book) {
  reports::Table table{"At equal error in time",
                       "Cost",
                       "CPU seconds on the straight line between neighbouring runs (log-log).",
                       {"rms error [m]"},
                       {}};
  for (const auto& curve : curves) table.header.push_back(curve.label + " [s]");
  table.header.push_back("backward Euler / best");
  for (const double error : {1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6}) {
    std::vector<std::string> row = {fmt::format("{:g}", error)};
    double best = std::numeric_limits<double>::infinity();
    for (const auto& curve : curves) {
      const double cpu = cpu_at(curve, error);
      row.push_back(seconds_text(cpu));
      if (!std::isnan(cpu)) best = std::min(best, cpu);
    }
    if (std::isinf(best)) continue;
    const double ratio = cpu_at(curves.back(), error) / best;
    row.push_back(std::isnan(ratio) ? "-" : fmt::format("{:.1f}", ratio));
    table.rows.push_back(row);
    if (error == 1e-3 && !std::isnan(ratio))
      book.show("shown", "backward Euler's CPU seconds over the best integrator's at an error of 1 mm", ratio, "-");
  }
  book.tabulate(table);
}

struct Sweep {
  fem::Integrator integrator;
  std::vector<double> tolerances;
};

std::vector<Sweep> sweeps() {
  // backward Euler last: the others are set beside it
  return {{fem::Integrator::bdf, {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}},
          {fem::Integrator::dirk, {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}},
          {fem::Integrator::backward_euler, {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}}};
}

void work(const WorkCase& in, CaseBook& book) {
  fem::RichardsProblem problem = in.problem(in.cells);
  problem.tolerance = 1e-9;
  const auto same_mesh = book.solve(fmt::format("yardstick, {} cells, 1e-9", in.cells), problem);
  auto in_time =
      log_figure({"work_precision", fmt::format("Error in time over CPU seconds, {} cells", in.cells), "Cost"});
  reports::Table table{"Work and precision",
                       "Cost",
                       "Errors in time: against the same mesh at 1e-9.",
                       {"integrator", "tolerance", "steps", "CPU [s]", "rms error of the head [m]"},
                       {}};
  for (const Sweep& sweep : sweeps()) {
    reports::Series curve = line(integrator_name(sweep.integrator));
    for (const double tolerance : sweep.tolerances) {
      const Point point = run(in, in.cells, sweep.integrator, tolerance, same_mesh, book);
      put(curve, point.cpu, point.error);
      table.rows.push_back({curve.label, fmt::format("{:g}", tolerance), fmt::format("{:g}", point.steps),
                            fmt::format("{:.4f}", point.cpu), fmt::format("{:.2e}", point.error)});
    }
    in_time.series.push_back(curve);
  }
  compare(in_time.series, book);
  book.tabulate(table);
  book.draw(in_time);

  problem = in.problem(in.finest);
  problem.tolerance = 1e-8;
  const auto finest = book.solve(fmt::format("yardstick, {} cells, 1e-8", in.finest), problem);
  auto in_all = log_figure({"work_precision_mesh", "Error in space and time over CPU seconds, BDF", "Cost"});
  for (const int cells : in.meshes) {
    reports::Series curve = line(fmt::format("{} cells", cells));
    for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
      const Point point = run(in, cells, fem::Integrator::bdf, tolerance, finest, book);
      put(curve, point.cpu, point.error);
    }
    in_all.series.push_back(curve);
  }
  in_all.note = fmt::format("against {} cells at 1e-8", in.finest);
  book.draw(in_all);
}

}  // namespace

std::vector<Case> work_precision_cases() {
  const auto layer = srivastava_yeh_layer(10, true);
  const WorkCase mild{[layer](int cells) { return srivastava_yeh_problem(layer, cells); }, 100, {50, 100, 200}, 800, 3};
  const WorkCase sharp{celia_new_mexico, 100, {50, 100, 200}, 800, 1};
  const std::string requirement =
      "What accuracy costs: every integrator over its tolerance, the best one over the mesh.";
  return {{"work_precision_srivastava_yeh", "Work and precision: Srivastava-Yeh, wetting, alpha = 10 /m", requirement,
           "Method of SciMLBenchmarks: the least CPU time of three runs.", Effort::everyday,
           [mild](CaseBook& book) { work(mild, book); }},
          {"work_precision_celia", "Work and precision: Celia, New Mexico soil", requirement,
           "Method of SciMLBenchmarks.", Effort::heavy, [sharp](CaseBook& book) { work(sharp, book); }}};
}

}  // namespace wetfront::verification
