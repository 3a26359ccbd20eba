#include "fem_reference/problem_checks.h"
#include "fem_reference/ranks/shared_solve.h"
#include "fem_reference/record/recorder.h"
#include "fem_reference/space/indicator.h"
#include "fem_reference/space/transfer.h"
#include "fem_reference/system.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace wetfront::fem_reference {
namespace {

// The record keeps every step; sound runs take thousands.
constexpr long most_steps = 2'000'000;

/// One run: the march through time, on meshes that follow the front where the problem asks for it.
class Run {
 public:
  /// `shared`: on all ranks at once.
  Run(const RichardsProblem& problem, meshes::Progress progress, bool shared = false)
      : problem_(problem), progress_(progress), space_(problem, shared), recorder_(problem) {
    if (problem.adaptivity) indicator_.emplace(problem);
    system_ = std::make_unique<System>(problem, space_.discretisation());
  }

  meshes::FieldHistory march() {
    try {
      begin();
      while (state_.time < problem_.end_time) {
        const double stop = next_stop();
        step(stop);
        if (state_.time == stop) take_snapshots();
        const bool breaks = at_break(), moved = wants_other_mesh() && adapt();
        if (breaks) system_->boundary.set_time(state_.time);
        if (breaks || moved) restart();
      }
    } catch (const StepFailure& failure) {
      recorder_.note(failure.what());
      throw GaveUp(failure.what(), finish());
    }
    return finish();
  }

 private:
  void begin() {
    take_initial_state();
    if (indicator_) adapt_to_initial_state();
    system_->boundary.set_time(0);
    recorder_.attach(system_->flow, system_->boundary, state_);
    recorder_.record_step(state_);
    take_snapshots();
    restart();
  }

  void take_initial_state() {
    state_.head = system_->space.initial_head;
    state_.water = system_->flow.water_at(state_.head);
    state_.totals.assign(system_->kernel.ledger_size(), 0.0);
  }

  // With the heads that the boundary imposes: a jump there is a front.
  void adapt_to_initial_state() {
    for (int pass = 0; pass < problem_.adaptivity->levels; ++pass) {
      system_->boundary.set_time(0);
      std::vector<double> head = state_.head;
      system_->kernel.make_consistent(head);
      if (!space_.adapt(marks(head))) return;
      effort_.add(*system_);
      system_ = std::make_unique<System>(problem_, space_.discretisation());
      take_initial_state();
    }
  }

  std::vector<Space::Mark> marks(const std::vector<double>& head) const {
    return indicator_->marks(system_->space, system_->flow.laws(), head);
  }

  bool wants_other_mesh() const {
    if (!indicator_) return false;
    constexpr long steps_between_looks = 50;  // at what lies behind; joining saves work, but is not urgent
    const std::vector<SoilLaw>& laws = system_->flow.laws();
    return indicator_->due(system_->space, laws, state_.head) ||
           (steps_ % steps_between_looks == 0 && indicator_->mostly_joinable(system_->space, laws, state_.head));
  }

  // One pass halves a cell once; what comes to light then may ask for more.
  bool adapt() {
    bool changed = false;
    for (int pass = 0; pass <= problem_.adaptivity->levels; ++pass) {
      if (!space_.adapt(marks(state_.head))) break;
      move_to(std::make_unique<System>(problem_, space_.discretisation()));
      changed = true;
    }
    if (changed) {
      make_boundary_consistent();
      ++adapts_;
    }
    return changed;
  }

  void move_to(std::unique_ptr<System> next) {
    next->boundary.set_time(state_.time);
    std::vector<char> fixed(next->space.dof_count, 0);
    for (const HeldDof& held : next->boundary.held()) fixed[held.dof] = held.kind == HeldDof::Kind::head;
    Transferred moved = transfer(system_->flow, state_.head, next->flow, fixed);
    recorder_.detach(state_);
    recorder_.lose(moved.lost);
    water_moved_ += moved.moved;
    water_lost_ += std::abs(moved.lost);
    effort_.add(*system_);
    system_ = std::move(next);
    state_.head = std::move(moved.head);
    state_.water = system_->flow.water_at(state_.head);
    state_.totals.assign(system_->kernel.ledger_size(), 0.0);
    recorder_.attach(system_->flow, system_->boundary, state_);
  }

  // The jump from the initial state to what the boundary demands happens at t = 0, a jump of a given head, or of a node
  // that a rising water level reaches, at its break; all of it is in the ledger.
  void make_boundary_consistent() {
    const std::vector<double> taken = system_->kernel.make_consistent(state_.head);
    state_.water = system_->flow.water_at(state_.head);
    const std::size_t first = system_->boundary.held().size();
    std::vector<double> of_all_ranks = taken;
    system_->space.ranks.sum(of_all_ranks);
    for (std::size_t c = 0; c < taken.size(); ++c) {
      state_.totals[first + c] += taken[c];
      if (of_all_ranks[c] == 0 || state_.time > 0) continue;
      recorder_.note("the initial state contradicts side '" + system_->boundary.side_name(static_cast<int>(c)) + "': " +
                     std::to_string(of_all_ranks[c]) + " m^dim of water left there at t = 0 to make it consistent");
    }
  }

  void restart() {
    if (state_.time == 0 || system_->boundary.heads_move()) make_boundary_consistent();
    system_->integrator->start(state_);
  }

  double next_stop() const {
    const auto& breaks = system_->boundary.breaks();
    const auto next = std::upper_bound(breaks.begin(), breaks.end(), state_.time);
    double stop = next == breaks.end() ? problem_.end_time : std::min(*next, problem_.end_time);
    if (next_output_ < problem_.output_times.size()) stop = std::min(stop, problem_.output_times[next_output_]);
    return stop;
  }

  bool at_break() const {
    const auto& breaks = system_->boundary.breaks();
    return std::binary_search(breaks.begin(), breaks.end(), state_.time);
  }

  void step(double stop) {
    if (++steps_ > most_steps) {
      throw StepFailure(describe_failure(system_->kernel, state_.time, state_.time / static_cast<double>(most_steps),
                                         std::to_string(most_steps) + " steps of this size on average got no farther"));
    }
    system_->integrator->step(state_, stop);
    effort_.step_taken(*system_);
    recorder_.record_step(state_);
    constexpr long steps_between_reports = 50;
    if (progress_ != nullptr && steps_ % steps_between_reports == 0) {
      progress_(state_.time, problem_.end_time, "reference");
    }
  }

  void take_snapshots() {
    const auto& times = problem_.output_times;
    for (; next_output_ < times.size() && times[next_output_] <= state_.time; ++next_output_) {
      recorder_.record_snapshot(state_);
    }
  }

  meshes::FieldHistory finish() {
    meshes::FieldHistory history = recorder_.finish(state_);
    effort_.report(problem_, *system_, cpu_now() - start_, history);
    if (problem_.adaptivity) {
      history.counters["adapts"] = static_cast<double>(adapts_);
      history.counters["water moved by adapting"] = water_moved_;
      history.counters["water lost by adapting"] = water_lost_;
    }
    return history;
  }

  double start_ = cpu_now();
  const RichardsProblem& problem_;
  meshes::Progress progress_;
  Space space_;
  Recorder recorder_;
  std::optional<Indicator> indicator_;
  Effort effort_;
  std::unique_ptr<System> system_;
  State state_;
  std::size_t next_output_ = 0;
  long steps_ = 0, adapts_ = 0;
  double water_moved_ = 0, water_lost_ = 0;  ///< [m^dim]
};

}  // namespace

meshes::FieldHistory solve(const RichardsProblem& problem, meshes::Progress progress) {
  check_problem(problem);
  if (!other_ranks()) return march_alone(problem, progress);
  const std::string why_not = not_shareable(problem);
  if (why_not.empty()) return lead(problem, [&] { return march_together(problem, progress); });
  meshes::FieldHistory history = march_alone(problem, progress);
  history.log.push_back("solved on one rank of several: " + why_not);
  return history;
}

meshes::FieldHistory march_alone(const RichardsProblem& problem, meshes::Progress progress) {
  return Run(problem, progress).march();
}

meshes::FieldHistory march_together(const RichardsProblem& problem, meshes::Progress progress) {
  return Run(problem, progress, true).march();
}

}  // namespace wetfront::fem_reference
