#include "fem_reference/integrator.h"
#include "fem_reference/problem_checks.h"
#include "fem_reference/recorder.h"

#include <algorithm>
#include <set>
#include <sstream>

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

// The record keeps every step; sound runs take thousands.
constexpr long most_steps = 2'000'000;

/// One run: the objects in the order in which they need each other, and the march through time.
class Run {
 public:
  Run(const RichardsProblem& problem, meshes::Progress progress)
      : problem_(problem),
        progress_(progress),
        space_(discretise(problem)),
        boundary_(problem, space_),
        flow_(problem, space_, boundary_),
        kernel_(flow_, boundary_, newton_tolerance(problem)),
        integrator_(problem.integrator == Integrator::bdf
                        ? make_bdf(kernel_, Tolerances(problem.tolerance))
                        : make_backward_euler(kernel_, Tolerances(problem.tolerance))),
        recorder_(problem, flow_, boundary_) {}

  meshes::FieldHistory march() {
    try {
      begin();
      const std::vector<double> breaks = boundary_.breaks();
      std::set<double> stops(breaks.begin(), breaks.end());
      stops.insert(problem_.output_times.begin(), problem_.output_times.end());
      stops.insert(problem_.end_time);
      stops.erase(0.0);
      for (double stop : stops) {
        march_to(stop);
        take_snapshots();
        if (std::binary_search(breaks.begin(), breaks.end(), stop)) restart();
      }
    } catch (const StepFailure& failure) {
      recorder_.note(failure.what());
      throw GaveUp(failure.what(), finish());
    }
    return finish();
  }

 private:
  void begin() {
    state_.head = space_.initial_head;
    state_.water = flow_.water_at(state_.head);
    state_.totals.assign(kernel_.ledger_size(), 0.0);
    recorder_.record_step(state_);
    take_snapshots();
    restart();
  }

  // The jump from the initial state to what the boundary demands happens at t = 0, a jump of a given head, or of a node
  // that a rising water level reaches, at its break; all of it is in the ledger.
  void make_boundary_consistent() {
    const std::vector<double> taken = kernel_.make_consistent(state_.head);
    state_.water = flow_.water_at(state_.head);
    const std::size_t first = boundary_.held().size();
    for (std::size_t c = 0; c < taken.size(); ++c) {
      state_.totals[first + c] += taken[c];
      if (taken[c] == 0 || state_.time > 0) continue;
      recorder_.note("the initial state contradicts side '" + boundary_.side_name(static_cast<int>(c)) +
                     "': " + std::to_string(taken[c]) + " m^dim of water left there at t = 0 to make it consistent");
    }
  }

  void restart() {
    boundary_.set_time(state_.time);
    if (state_.time == 0 || boundary_.heads_move()) make_boundary_consistent();
    integrator_->start(state_);
  }

  void march_to(double stop) {
    while (state_.time < stop) {
      if (++steps_ > most_steps) {
        std::ostringstream text;
        text << "gave up at t = " << state_.time << " s: " << most_steps << " steps were not enough";
        throw StepFailure(text.str());
      }
      integrator_->step(state_, stop);
      recorder_.record_step(state_);
      constexpr long steps_between_reports = 50;
      if (progress_ != nullptr && steps_ % steps_between_reports == 0) {
        progress_(state_.time, problem_.end_time, "reference");
      }
    }
  }

  void take_snapshots() {
    const auto& times = problem_.output_times;
    for (; next_output_ < times.size() && times[next_output_] <= state_.time; ++next_output_) {
      recorder_.record_snapshot(state_);
    }
  }

  meshes::FieldHistory finish() { return recorder_.finish(state_, kernel_, *integrator_, cpu_now() - start_); }

  double start_ = cpu_now();
  const RichardsProblem& problem_;
  meshes::Progress progress_;
  Discretisation space_;
  Boundary boundary_;
  FlowOperator flow_;
  StageKernel kernel_;
  std::unique_ptr<TimeIntegrator> integrator_;
  Recorder recorder_;
  State state_;
  std::size_t next_output_ = 0;
  long steps_ = 0;
};

}  // namespace

meshes::FieldHistory solve(const RichardsProblem& problem, meshes::Progress progress) {
  check_problem(problem);
  return Run(problem, progress).march();
}

}  // namespace wetfront::fem_reference
