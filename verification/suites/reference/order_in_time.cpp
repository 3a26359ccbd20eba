#include "verification/present/figure_frame.h"
#include "verification/suites/case_book.h"
#include "verification/suites/closed_form_case.h"
#include "verification/suites/reference/families.h"
#include "verification/suites/reference/integrators.h"
#include "verification/suites/reference/manufactured_problem.h"
#include "verification/suites/series.h"

#include <fmt/format.h>

#include <cmath>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

struct Sweep {
  fem::Integrator integrator;
  std::vector<double> tolerances;
  bool over_step;  ///< order over the mean step; else over the tolerance
  OrderGate gate;
};

/// Slope of log y over log x by least squares.
double slope(const std::vector<double>& x, const std::vector<double>& y) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = std::log(x[i]), v = std::log(y[i]);
    sx += u, sy += v, sxx += u * u, sxy += u * v;
  }
  const double n = static_cast<double>(x.size());
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

void measure(const Sweep& sweep, CaseBook& book) {
  fem::RichardsProblem problem = manufactured_problem(manufactured_box(1, true), 1, 64);
  problem.tolerance = 1e-10;
  const std::vector<double> exact = heads_of(book.solve("BDF, 1e-10: the yardstick", problem).snapshots.back());
  const std::string name = integrator_name(sweep.integrator);
  reports::Series over_step = line(name), over_tolerance = line(name);
  problem.integrator = sweep.integrator;
  for (const double tolerance : sweep.tolerances) {
    problem.tolerance = tolerance;
    const auto history = book.solve(fmt::format("{}, {:g}", name, tolerance), problem);
    const double error = relative_l2(heads_of(history.snapshots.back()), exact);
    put(over_step, problem.end_time / history.counters.at("steps"), error);
    put(over_tolerance, tolerance, error);
  }
  const double by_step = slope(over_step.x, over_step.y), by_tolerance = slope(over_tolerance.x, over_tolerance.y);
  book.judge_order("order",
                   sweep.over_step ? "slope of the error over the mean step" : "slope of the error over the tolerance",
                   sweep.over_step ? by_step : by_tolerance, sweep.gate);
  book.show("shown", sweep.over_step ? "slope over the tolerance" : "slope over the mean step",
            sweep.over_step ? by_tolerance : by_step, "orders");
  auto steps = figure_frame({"error_over_step", "Error over the mean time step", "Convergence"}, {"mean step", "s"},
                            {"relative L2 error of the head", "-"});
  auto tolerances = figure_frame({"error_over_tolerance", "Error over the tolerance", "Convergence"},
                                 {"tolerance", "-"}, {"relative L2 error of the head", "-"});
  steps.log_x = steps.log_y = tolerances.log_x = tolerances.log_y = true;
  steps.note = fmt::format("slope {:.2f}", by_step);
  tolerances.note = fmt::format("slope {:.2f}", by_tolerance);
  steps.series = {over_step};
  tolerances.series = {over_tolerance};
  book.draw(steps);
  book.draw(tolerances);
}

Case in_time(const char* name, const char* title, const Sweep& sweep) {
  return {name,
          fmt::format("Order in time, {}", title),
          "The error in time falls as the integrator promises, on a smooth problem and one mesh.",
          "manufactured solution, van Genuchten, 64 cells; error against the same mesh at 1e-10.",
          Effort::quick,
          [sweep](CaseBook& book) { measure(sweep, book); }};
}

}  // namespace

std::string integrator_name(fem::Integrator integrator) {
  switch (integrator) {
    case fem::Integrator::bdf:
      return "BDF (IDAS)";
    case fem::Integrator::backward_euler:
      return "backward Euler";
    case fem::Integrator::dirk:
      return "DIRK";
  }
  return "";
}

std::vector<Case> order_in_time_cases() {
  return {in_time("order_in_time_bdf", "BDF of variable order",
                  {fem::Integrator::bdf,
                   {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8},
                   false,
                   {0.7, 1.2, "a BDF of variable order promises an error in proportion to the tolerance"}}),
          in_time("order_in_time_backward_euler", "adaptive backward Euler",
                  {fem::Integrator::backward_euler,
                   {1e-4, 1e-5, 1e-6, 1e-7},
                   true,
                   {0.9, 1.1, "backward Euler is of first order; its steps here differ little"}}),
          in_time("order_in_time_dirk", "SDIRK of order 4",
                  {fem::Integrator::dirk,
                   // tighter, and Newton's 1e-12 in W is what is left of the error: 1e-9
                   {1e-1, 1e-2, 1e-3, 1e-4},
                   true,
                   {3.5, 4.5, "SDIRK(5,3,4) is of order 4; 0.5 for the steps' uneven sizes"}})};
}

}  // namespace wetfront::verification
