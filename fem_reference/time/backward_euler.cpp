#include "fem_reference/time/integrator.h"

#include <algorithm>
#include <cmath>

namespace wetfront::fem_reference {
namespace {

/// Adaptive backward Euler: the cross-check that shares only the stage kernel with the BDF.
/// The local error is dt/(2 dt + dt_old) times the distance from the linear extrapolation of the last step.
class BackwardEuler : public TimeIntegrator {
 public:
  BackwardEuler(StageKernel& kernel, Tolerances tolerances) : kernel_(kernel), tolerances_(tolerances) {}

  void start(const State& state) override {
    kernel_.set_time(state.time);
    water_rate_ = kernel_.rates(state.head);
    head_rate_ = head_rates(kernel_.flow(), water_rate_);
    last_step_ = 0;
    // First step: the change predicted from the rates stays below the tolerance.
    const std::vector<double> none(state.head.size(), 0.0);
    double size = weighted_norm(state, head_rate_, water_rate_);
    next_step_ = 0.5 / std::max(size, 1e-300);
  }

  void step(State& state, double stop) override {
    const double span = stop - state.time;
    for (;;) {
      double dt = std::min(next_step_, span);
      if (dt < span && dt > 0.5 * span) dt = 0.5 * span;  // two equal steps rather than a sliver
      if (!(dt > 1e-13 * std::max(stop, 1.0))) throw StepFailure(describe_failure(kernel_, state.time, dt));
      std::vector<double> head = state.head;
      for (std::size_t i = 0; i < head.size(); ++i) head[i] += dt * head_rate_[i];
      const std::vector<double> predicted = head;
      kernel_.set_time(dt == span ? stop : state.time + dt);
      if (!kernel_.solve(state.water, dt, head)) {
        next_step_ = 0.25 * dt;
        continue;
      }
      const double error = local_error(state, dt, head, predicted);
      const double factor = std::clamp(0.9 / std::sqrt(std::max(error, 1e-10)), 0.2, 2.0);
      if (error > 1) {
        ++rejected_;
        next_step_ = dt * std::min(factor, 0.9);
        continue;
      }
      accept(state, dt, std::move(head), dt == span ? stop : state.time + dt);
      next_step_ = std::max(dt == span ? next_step_ : 0.0, dt * factor);
      return;
    }
  }

  std::string name() const override { return "adaptive backward Euler"; }

  void report(std::map<std::string, double>& counters) const override {
    counters["steps"] = static_cast<double>(steps_);
    counters["rejected steps"] = static_cast<double>(rejected_ + kernel_.failed_solves);
  }

 private:
  double weighted_norm(const State& state, const std::vector<double>& head, const std::vector<double>& water) const {
    double sum = 0;
    for (std::size_t i = 0; i < head.size(); ++i) {
      const double h = head[i] / (tolerances_.relative * std::abs(state.head[i]) + tolerances_.head);
      const double w = water[i] / (tolerances_.relative * std::abs(state.water[i]) + tolerances_.water);
      sum += h * h + w * w;
    }
    return std::sqrt(sum / (2.0 * static_cast<double>(head.size())));
  }

  double local_error(const State& state, double dt, const std::vector<double>& head,
                     const std::vector<double>& predicted) const {
    std::vector<double> dh(head.size()), dw(head.size());
    for (std::size_t i = 0; i < head.size(); ++i) {
      dh[i] = head[i] - predicted[i];
      dw[i] = kernel_.flow().water()[i] - state.water[i] - dt * water_rate_[i];
    }
    return dt / (2 * dt + last_step_) * weighted_norm(state, dh, dw);
  }

  void accept(State& state, double dt, std::vector<double> head, double time) {
    const std::vector<double>& water = kernel_.flow().water();
    for (std::size_t i = 0; i < head.size(); ++i) {
      head_rate_[i] = (head[i] - state.head[i]) / dt;
      water_rate_[i] = (water[i] - state.water[i]) / dt;
    }
    std::vector<double> rates(state.totals.size());
    kernel_.ledger_rates(rates);
    for (std::size_t k = 0; k < rates.size(); ++k) state.totals[k] += dt * rates[k];
    state.head = std::move(head);
    state.water = water;
    state.time = time;
    last_step_ = dt;
    ++steps_;
  }

  StageKernel& kernel_;
  Tolerances tolerances_;
  std::vector<double> head_rate_, water_rate_;
  double last_step_ = 0, next_step_ = 0;
  long steps_ = 0, rejected_ = 0;
};

}  // namespace

std::unique_ptr<TimeIntegrator> make_backward_euler(StageKernel& kernel, Tolerances tolerances) {
  return std::make_unique<BackwardEuler>(kernel, tolerances);
}

}  // namespace wetfront::fem_reference
