#pragma once

#include "mpm/body_record.h"
#include "mpm/grid/grid.h"
#include "mpm/grid/material_points.h"
#include "mpm/plan.h"
#include "mpm/plan/effect.h"
#include "mpm/plan/kernel.h"

#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

namespace wetfront::mpm {

/// Physical time of the step under way. A kernel that cannot take the whole step shortens `dt` and `end`.
struct Clock {
  double time = 0;     ///< s, where the step starts
  double end = 0;      ///< s, where it ends: exactly the next event when that is reached
  double event = 0;    ///< s, the next output time, break of a rain record or end of the stage
  double dt = 0;       ///< s, end - time
  bool broken = true;  ///< the loading has just changed abruptly (start of a stage, break of a rain record)
};

/// Thrown by a kernel when no step can be taken; Simulation adds the history and throws GaveUp.
struct StepFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The columns of a run: over points, over nodes, and single rows of numbers ("run"; e.g. the water ledger).
template <int dim>
struct Fields {
  explicit Fields(const Problem<dim>& problem);
  Grid<dim> grid;
  MaterialPoints<dim> points;
  ColumnSet run{1};
  BodyRecord body;
};

/// The plan of one stage: columns, kernels in phases, time-step limits. Effects fill it when they join.
template <int dim>
class StagePlan {
 public:
  StagePlan(const Problem<dim>& problem, std::size_t stage, Fields<dim>& fields);
  StagePlan(const StagePlan&) = delete;

  // --- what effects call from join ---
  const Problem<dim>& problem;
  const Stage& stage;
  Fields<dim>& fields;
  Clock clock;

  Column& provide_on_points(const ColumnSpec& spec) { return fields.points.columns.provide(spec, joining_); }
  Column& provide_on_nodes(const ColumnSpec& spec) { return fields.grid.columns.provide(spec, joining_); }
  Column& provide_on_run(const ColumnSpec& spec) { return fields.run.provide(spec, joining_); }
  Column& require_on_points(const std::string& name) { return require(fields.points.columns, name); }
  Column& require_on_nodes(const std::string& name) { return require(fields.grid.columns, name); }
  Column& require_on_run(const std::string& name) { return require(fields.run, name); }

  /// A kernel that runs once per step.
  Kernel& add(Phase phase, const std::string& name, std::function<void()> body);
  /// A kernel over the occupied cells of a region; `body(const Block&)` is inlined into the loop.
  template <class Body>
  Kernel& add_over_blocks(Phase phase, const std::string& name, int region, Body body) {
    return add(phase, name, [&points = fields.points, region, body = std::move(body)]() mutable {
      for (const Block& block : points.blocks(region)) body(block);
    });
  }
  template <class Body>
  Kernel& add_over_blocks(Phase phase, const std::string& name, Body body) {
    return add(phase, name, [&points = fields.points, body = std::move(body)]() mutable {
      for (const Block& block : points.blocks()) body(block);
    });
  }
  /// A kernel that its effect runs itself, several times per step (inside a Newton iteration).
  Kernel& add_iterated(Phase phase, const std::string& name, std::function<void()> body);

  /// The step must stay below `seconds()` times the stage's safety factor, or the scheme blows up.
  void add_stability_limit(const std::string& name, const std::string& formula, std::function<double()> seconds);
  /// The step should stay below `seconds()`, for accuracy's sake.
  void add_accuracy_limit(const std::string& name, const std::string& formula, std::function<double()> seconds);
  /// For `explain` only: CPU seconds per step, and number of steps where no limit tells it.
  void expect_cost(double cpu_seconds_per_step) { expected_cost_ += cpu_seconds_per_step; }
  void expect_steps(double steps) { expected_steps_ = steps; }
  /// Runs when a stage begins, columns allocated and those of the stage before still there.
  void at_entry(std::function<void()> body) { at_entry_.push_back(std::move(body)); }
  /// Runs when a stage begins (after every at_entry) and when a run is continued: rebuilds step columns and caches.
  void at_ready(std::function<void()> body) { at_ready_.push_back(std::move(body)); }
  /// Runs when a stage begins, after every at_ready: first values that need the caches.
  void at_begin(std::function<void()> body) { at_begin_.push_back(std::move(body)); }
  /// Fills what the effect knows into a snapshot.
  void at_output(std::function<void(meshes::Snapshot&)> body) { at_output_.push_back(std::move(body)); }
  /// Adds to the record after every accepted step (gauges) and at the start of the run.
  void at_record(std::function<void(double time, meshes::FieldHistory&)> body) {
    at_record_.push_back(std::move(body));
  }
  /// A time at which the loading breaks [s].
  void add_break(double time) { breaks_.push_back(time); }
  /// Counters and other ends for the history.
  void at_finish(std::function<void(meshes::FieldHistory&)> body) { at_finish_.push_back(std::move(body)); }

  // --- what Simulation and `plan` call ---
  void join(std::unique_ptr<Effect<dim>> effect);
  /// Every required column is provided; throws CannotPlan otherwise.
  void check() const;
  void enter();  ///< allocates, initialises, frees what the stage does not need
  void resume(const std::map<std::string, std::vector<double>>& stored);
  void run_step();  ///< all kernels of all phases, in order
  double propose_step() const;
  /// The least stability limit times the stage's safety factor [s]; infinity: none.
  double stable_step() const;
  /// Conditionally stable: the step follows from a stability limit.
  bool conditionally_stable() const;
  double begin_time() const { return stage_index_ == 0 ? 0.0 : problem.stages[stage_index_ - 1].end_time; }
  std::size_t index() const { return stage_index_; }
  double expected_cost() const { return expected_cost_; }    ///< CPU seconds per step
  double expected_steps() const { return expected_steps_; }  ///< 0: the limits tell
  void output(meshes::Snapshot& snapshot) const;
  void record(double time, meshes::FieldHistory& history) const;
  void finish(meshes::FieldHistory& history) const;
  const std::vector<double>& breaks() const { return breaks_; }
  PlanInfo info() const;
  /// Name of the scheme, for `explain` and the history.
  std::string scheme() const;

 private:
  struct Limit {
    std::string name, formula;
    std::function<double()> seconds;
    bool stability;
  };
  struct Requirement {
    const ColumnSet* set;
    std::string column, effect;
  };
  Column& require(ColumnSet& set, const std::string& name);

  std::size_t stage_index_;
  std::string joining_;
  double expected_cost_ = 0, expected_steps_ = 0;
  std::vector<std::unique_ptr<Effect<dim>>> effects_;
  std::vector<Requirement> requirements_;
  std::vector<std::unique_ptr<Kernel>> kernels_, iterated_;  ///< kernels_ sorted by phase
  std::vector<Limit> limits_;
  std::vector<std::function<void()>> at_entry_, at_ready_, at_begin_;
  std::vector<std::function<void(meshes::Snapshot&)>> at_output_;
  std::vector<std::function<void(double, meshes::FieldHistory&)>> at_record_;
  std::vector<std::function<void(meshes::FieldHistory&)>> at_finish_;
  std::vector<double> breaks_;
};

}  // namespace wetfront::mpm
