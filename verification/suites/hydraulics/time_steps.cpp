#include "mpm/simulation.h"
#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/hydraulics/families.h"
#include "verification/suites/on_points.h"
#include "verification/suites/reference/closed_forms.h"
#include "verification/suites/seed_column.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

using mpm::TimeIntegrator;

std::string name_of(TimeIntegrator integrator) {
  return integrator == TimeIntegrator::bdf2 ? "BDF2" : "backward Euler";
}

/// Largest relative L2 of the nodal pressure over the output times, two runs on one mesh.
double difference(const meshes::FieldHistory& a, const meshes::FieldHistory& b) {
  double worst = 0;
  for (std::size_t t = 0; t < b.snapshots.size(); ++t)
    worst = std::max(worst, relative_l2(a.snapshots[t].node_pressure, b.snapshots[t].node_pressure));
  return worst;
}

/// Srivastava-Yeh wetting in steps of one length, read at 10 and 20 h, when the jump of the flux is well behind.
mpm::Problem<2> equal_steps(TimeIntegrator integrator, double step) {
  auto reference = srivastava_yeh_case(10, true, {}).problem(50);
  reference.output_times = {10 * 3600., 20 * 3600.};
  reference.end_time = 20 * 3600.;
  mpm::Problem<2> problem = on_points(reference);
  problem.stages[0].integrator = integrator;
  problem.stages[0].largest_step = step;
  problem.stages[0].time_tolerance = 1e6;  // no error control: the step is what is varied
  return problem;
}

void order(CaseBook& book) {
  auto figure = figure_frame({"error_over_step", "Error in time over the step", "Convergence"}, {"step", "s"},
                             {"relative L2 of the nodal pressure", "-"});
  figure.log_x = figure.log_y = true;
  const auto yardstick = book.solve("BDF2, 22.5 s: the yardstick", equal_steps(TimeIntegrator::bdf2, 22.5));
  for (const auto integrator : {TimeIntegrator::bdf2, TimeIntegrator::backward_euler}) {
    auto curve = line(name_of(integrator));
    for (const double step : {1440., 720., 360., 180.})
      put(curve, step,
          difference(book.solve(fmt::format("{}, {:g} s", name_of(integrator), step), equal_steps(integrator, step)),
                     yardstick));
    const bool second = integrator == TimeIntegrator::bdf2;
    book.judge_order("order", fmt::format("observed order in dt, {}, between 360 and 180 s", name_of(integrator)),
                     std::log2(curve.y[2] / curve.y[3]),
                     second ? OrderGate{1.8, 2.2, "BDF2 is of second order"}
                            : OrderGate{0.9, 1.1, "backward Euler is of first order"});
    figure.series.push_back(curve);
  }
  book.draw(figure);
}

struct Run {
  double cpu, newton, error;
};

struct Curve {
  std::string name;
  std::vector<Run> runs;  ///< towards smaller errors
};

/// Error at a cost, on the straight line between neighbours in log-log, extended beyond the ends.
double error_at(const Curve& curve, double Run::*cost, double at) {
  std::size_t i = 1;
  while (i + 1 < curve.runs.size() && curve.runs[i].*cost < at) ++i;
  const Run &a = curve.runs[i - 1], &b = curve.runs[i];
  const double slope = std::log(b.error / a.error) / std::log(b.*cost / (a.*cost));
  return a.error * std::pow(at / (a.*cost), slope);
}

mpm::Problem<2> column(double rain, TimeIntegrator integrator, double tolerance) {
  mpm::Problem<2> problem = on_points(SeedColumn{rain}.problem(40, {0.25, 0.5, 0.75}));
  problem.stages[0].integrator = integrator;
  problem.stages[0].time_tolerance = tolerance;
  return problem;
}

Curve sweep(double rain, TimeIntegrator integrator, const meshes::FieldHistory& yardstick, CaseBook& book) {
  Curve curve{name_of(integrator), {}};
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const auto problem = column(rain, integrator, tolerance);
    const auto history = book.solve(fmt::format("{}, {:g}", curve.name, tolerance), problem);
    Run run{history.cpu_seconds, history.counters.at("Newton iterations"), difference(history, yardstick)};
    for (int again = 0; again < 2; ++again) {
      const double seconds = mpm::run(problem).cpu_seconds;
      book.spend(seconds);
      run.cpu = std::min(run.cpu, seconds);
    }
    curve.runs.push_back(run);
  }
  return curve;
}

void equal_cost(double rain, CaseBook& book) {
  const auto yardstick = book.solve("BDF2, 1e-7: the yardstick", column(rain, TimeIntegrator::bdf2, 1e-7));
  const Curve second = sweep(rain, TimeIntegrator::bdf2, yardstick, book),
              first = sweep(rain, TimeIntegrator::backward_euler, yardstick, book);
  auto figure = figure_frame({"work_precision", "Error in time over CPU seconds, 40 cells", "Cost"}, {"CPU", "s"},
                             {"relative L2 of the nodal pressure", "-"});
  figure.log_x = figure.log_y = true;
  for (const Curve* curve : {&second, &first}) {
    auto series = line(curve->name);
    for (const Run& run : curve->runs) put(series, run.cpu, run.error);
    figure.series.push_back(series);
  }
  book.draw(figure);
  const Run& usual = second.runs[2];
  const double by_cpu = error_at(first, &Run::cpu, usual.cpu) / usual.error,
               by_work = error_at(first, &Run::newton, usual.newton) / usual.error;
  book.judge("equal_cost",
             fmt::format("3 over (error of backward Euler / error of BDF2 at equal CPU, tolerance 1e-5): {:.1f} times",
                         by_cpu),
             3 / by_cpu, {1, "1", "the issue asks for at least 3 times"});
  book.show("shown", "the same at equal Newton iterations", by_work, "times");
}

}  // namespace

std::vector<Case> time_step_cases() {
  std::vector<Case> cases = {
      {"order_in_time", "Order in dt of seepage", "The error falls with the step as the integrator promises.",
       "Srivastava & Yeh 1991, wetting, alpha = 10 /m; same mesh at 22.5 s as yardstick.", Effort::quick, order}};
  for (const double rain : {3e-5, 1.5e-4})
    cases.push_back({fmt::format("bdf2_against_backward_euler_{:g}", rain * 1e6),
                     fmt::format("BDF2 against backward Euler at equal cost, rain {:g} m/s", rain),
                     "BDF2's error in time is at least 3 times below backward Euler's at equal CPU.",
                     "The paper's column, 40 cells; against a 10 times tighter run.", Effort::everyday,
                     [rain](CaseBook& book) { equal_cost(rain, book); }});
  return cases;
}

}  // namespace wetfront::verification
