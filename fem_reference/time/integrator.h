#pragma once

#include "fem_reference/stage/stage_kernel.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace wetfront::fem_reference {

/// The state between two steps.
struct State {
  double time = 0;
  std::vector<double> head;    ///< psi [dof], m
  std::vector<double> water;   ///< W [dof], -
  std::vector<double> totals;  ///< integrals of StageKernel::ledger_rates [m^dim]
};

/// No step size lets the integrator go on; the state it was given is still the last good one.
struct StepFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Advances the state step by step. The rain does not change between two start() calls.
class TimeIntegrator {
 public:
  virtual ~TimeIntegrator() = default;
  /// (Re)starts from a state whose boundary heads are consistent, without history.
  virtual void start(const State& state) = 0;
  /// One accepted step, not beyond `stop`, onto which it steps exactly. Throws StepFailure.
  virtual void step(State& state, double stop) = 0;
  virtual std::string name() const = 0;
  virtual void report(std::map<std::string, double>& counters) const = 0;
};

/// Error weights follow from one tolerance: rtol = tol, atol_psi = tol * 1 m, atol_W = tol / 100
/// (reference.md: reference runs 1e-6 / 1e-6 m / 1e-8).
struct Tolerances {
  explicit Tolerances(double tolerance) : relative(tolerance), head(tolerance), water(0.01 * tolerance) {}
  double relative, head, water;
};

std::unique_ptr<TimeIntegrator> make_bdf(StageKernel& kernel, Tolerances tolerances);
std::unique_ptr<TimeIntegrator> make_dirk(StageKernel& kernel, Tolerances tolerances);
std::unique_ptr<TimeIntegrator> make_backward_euler(StageKernel& kernel, Tolerances tolerances);

/// dpsi/dt that belongs to dW/dt; 0 where the capacity is too small to tell (the head is then found by Newton).
std::vector<double> head_rates(const FlowOperator& flow, const std::vector<double>& water_rates);

/// One sentence on why the stage kernel failed: element, place, head, residual history. All ranks ask at once.
/// `reason`: instead of the kernel's own.
std::string describe_failure(const StageKernel& kernel, double time, double step, std::string reason = {});

}  // namespace wetfront::fem_reference
