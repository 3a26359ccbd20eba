#include "fem_reference/problem_checks.h"
#include "fem_reference/time/integrator.h"

#include <algorithm>
#include <cmath>

namespace wetfront::fem_reference {
namespace {

/// Pseudo-transient continuation: backward Euler steps that grow while the stage kernel takes them, until a step so
/// long that storage no longer counts moves no head.
class SteadyState {
 public:
  explicit SteadyState(const RichardsProblem& problem)
      : space_(discretise(problem)),
        boundary_(problem, space_),
        flow_(problem, space_, boundary_),
        kernel_(flow_, boundary_, newton_tolerance) {}

  std::vector<double> find() {
    boundary_.set_time(0);
    head_ = space_.initial_head;
    kernel_.make_consistent(head_);
    double step = first_step();
    for (int tries = 0; tries < most_steps; ++tries) {
      const long before = kernel_.iterations;
      const std::vector<double> old = head_;
      if (!kernel_.solve(flow_.water_at(old), step, head_)) {
        head_ = old;
        step *= 0.2;
        if (step < shortest) fail(step);
        continue;
      }
      const double change = largest_change(old);
      if (step >= longest && change < settled) return at_mesh_nodes();
      const bool easy = kernel_.iterations - before <= 5;
      step = std::min(longest, step * (easy ? 10 : 2));
    }
    fail(step);
  }

 private:
  static constexpr double newton_tolerance = 1e-12;  // -, a water content
  static constexpr double settled = 1e-10;           // m
  // 3e7 years: a metre of soil with K = 1e-10 m/s is at rest 1e5 times sooner.
  static constexpr double longest = 1e15, shortest = 1e-9;  // s
  static constexpr int most_steps = 500;

  // The first step changes the content by about 0.01 where it changes fastest.
  double first_step() {
    double fastest = 1e-12;
    for (double rate : kernel_.rates(head_)) fastest = std::max(fastest, std::abs(rate));
    return 0.01 / fastest;
  }

  double largest_change(const std::vector<double>& old) const {
    double change = 0;
    for (std::size_t i = 0; i < old.size(); ++i) {
      change = std::max(change, std::abs(head_[i] - old[i]) / std::max(1.0, std::abs(head_[i])));
    }
    return change;
  }

  [[noreturn]] void fail(double step) const {
    throw std::runtime_error("no steady state found; the pseudo-transient march " + describe_failure(kernel_, 0, step));
  }

  std::vector<double> at_mesh_nodes() const {
    std::vector<double> result;
    for (int dof : space_.node_dof) result.push_back(head_[dof]);
    return result;
  }

  Discretisation space_;
  Boundary boundary_;
  FlowOperator flow_;
  StageKernel kernel_;
  std::vector<double> head_;
};

}  // namespace

std::vector<double> steady_head(const RichardsProblem& problem) {
  check_problem(problem);
  return SteadyState(problem).find();
}

}  // namespace wetfront::fem_reference
