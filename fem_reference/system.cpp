#include "fem_reference/system.h"

#include <algorithm>

namespace wetfront::fem_reference {
namespace {

/// In a saturated row W changes by sigma dpsi only, so Newton must leave less than sigma atol_psi there, or the
/// integrator's error test sees nothing but Newton's noise (reference.md: 141,618 steps instead of 283; here a
/// tolerance of 1e-8 with 1e-12 gave up when the column was full). 1e-15 is a few roundings of W.
double newton_tolerance(const RichardsProblem& problem) {
  double tolerance = 1e-12;
  for (const Soil& soil : problem.soils) {
    if (soil.specific_storage > 0) {
      tolerance = std::min(tolerance, 0.01 * soil.specific_storage * Tolerances(problem.tolerance).head);
    }
  }
  return std::max(tolerance, 1e-15);
}

std::unique_ptr<TimeIntegrator> make_integrator(const RichardsProblem& problem, StageKernel& kernel) {
  const Tolerances tolerances(problem.tolerance);
  switch (problem.integrator) {
    case Integrator::backward_euler:
      return make_backward_euler(kernel, tolerances);
    case Integrator::dirk:
      return make_dirk(kernel, tolerances);
    default:
      return make_bdf(kernel, tolerances);
  }
}

void add(Cost& sum, const Cost& cost) {
  sum.seconds += cost.seconds;
  sum.calls += cost.calls;
}

}  // namespace

System::System(const RichardsProblem& problem, Discretisation discretisation)
    : space(std::move(discretisation)),
      boundary(problem, space),
      flow(problem, space, boundary),
      kernel(flow, boundary, newton_tolerance(problem)),
      integrator(make_integrator(problem, kernel)) {}

void Effort::add(const System& system) {
  std::map<std::string, double> counters;
  system.integrator->report(counters);
  counters["Newton iterations"] = static_cast<double>(system.kernel.iterations);
  counters["residual evaluations"] = static_cast<double>(system.kernel.evaluations);
  counters["nonlinear solves"] = static_cast<double>(system.kernel.solves);
  counters["failed nonlinear solves"] = static_cast<double>(system.kernel.failed_solves);
  for (const auto& [name, count] : counters) counters_[name] += count;
  fem_reference::add(evaluation_, system.flow.evaluation_cost);
  fem_reference::add(assembly_, system.flow.assembly_cost);
  fem_reference::add(linear_, system.kernel.linear_solve_cost);
  most_dofs_ = std::max(most_dofs_, system.space.dof_count);
}

void Effort::step_taken(const System& system) {
  ++steps_;
  dof_steps_ += system.space.dof_count;
}

void Effort::report(const RichardsProblem& problem, const System& last, double cpu_seconds,
                    meshes::FieldHistory& history) {
  add(last);
  for (const auto& [name, count] : counters_) history.counters[name] = count;
  if (problem.adaptivity && steps_ > 0) history.counters["degrees of freedom, mean over steps"] = dof_steps_ / steps_;
  history.solver = "fem: " + last.integrator->name() + ", Q" + std::to_string(problem.degree) + " lumped";
  double sums[] = {cpu_seconds, evaluation_.seconds, assembly_.seconds, linear_.seconds, 1.0 * most_dofs_};
  last.space.ranks.sum(sums);  // of all ranks, waiting for one another included
  cpu_seconds = sums[0];
  evaluation_.seconds = sums[1];
  assembly_.seconds = sums[2];
  linear_.seconds = sums[3];
  history.counters["degrees of freedom"] = sums[4];
  if (last.space.ranks.count() > 1) history.counters["ranks"] = last.space.ranks.count();
  history.cpu_seconds = cpu_seconds;
  history.cost = {
      {"stage", "residual", evaluation_.seconds, evaluation_.calls},
      {"stage", "Jacobian", assembly_.seconds, assembly_.calls},
      {"stage", "linear solve", linear_.seconds, linear_.calls},
      {"time", "integrator, recording, set-up", cpu_seconds - evaluation_.seconds - assembly_.seconds - linear_.seconds,
       static_cast<long>(history.counters["steps"])},
  };
}

}  // namespace wetfront::fem_reference
