#include "mpm/simulation.h"

#include "mpm/plan/derive_effects.h"
#include "mpm/plan/estimate.h"
#include "mpm/record/run_guard.h"
#include "mpm/record/water_ledger.h"

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {

namespace {

/// A conditionally stable stage takes millions of steps: its ledger and gauges are written at events and at this many
/// even intervals. (An implicit stage writes every accepted step.)
constexpr double rows_per_stage = 4000;

}  // namespace

template <int dim>
struct Simulation<dim>::Implementation {
  Problem<dim> problem;
  Fields<dim> fields;
  std::unique_ptr<StagePlan<dim>> plan;
  std::unique_ptr<RunGuard<dim>> guard;
  meshes::FieldHistory history;
  double time = 0, recorded_until = 0;
  std::size_t stage = 0;
  std::vector<double> breaks, events;  ///< of the stage; outputs and breaks [s, ascending]
  double cpu_start = thread_cpu_seconds();

  explicit Implementation(const Problem<dim>& p) : problem((check(p), check_cost(p), p)), fields(problem) {
    history.mesh = problem.mesh;
    enter_stage();
    record();
    write_snapshot();
  }

  Implementation(const Problem<dim>& p, const State& state)
      : problem((check(p), p)), fields(problem), history(state.history), time(state.time), stage(state.stage) {
    restore_point_counts(state);
    plan = make_plan(problem, stage, fields);
    plan->resume(state.fields);
    watch();
    const auto recorded = state.fields.find("recorded until");
    recorded_until = recorded != state.fields.end() ? recorded->second.at(0) : time;
  }

  void restore_point_counts(const State& state) {
    const auto stored = state.fields.find("points per cell");
    if (stored == state.fields.end() || stored->second.size() != fields.points.count_of_cell().size())
      throw CannotPlan(
          "cannot continue this run: its state has another number of cells than the problem (it belongs to "
          "another problem). Start the run anew");
    std::vector<std::size_t> counts(stored->second.begin(), stored->second.end());
    fields.points.set_counts(fields.grid, counts);
    // Conditions look for the surface of the body when the plan is made: where it is, not where it began.
    for (const char* name : {"position", "volume"}) {
      Column& column = fields.points.columns.at(name);
      const auto kept = state.fields.find(std::string("point.") + name);
      if (kept != state.fields.end() &&
          kept->second.size() == fields.points.size() * static_cast<std::size_t>(column.spec().components))
        fields.points.put_in_order(kept->second, column);
    }
  }

  bool finished() const { return stage + 1 == problem.stages.size() && time >= problem.stages[stage].end_time; }

  void enter_stage() {
    plan = make_plan(problem, stage, fields);
    plan->enter();
    watch();
    const std::string scheme = plan->scheme();
    history.solver += (history.solver.empty() ? "mpm: " : ", then ") + scheme;
    history.log.push_back("stage '" + plan->stage.name + "' begins: " + scheme);
    if (plan->conditionally_stable()) {
      const std::size_t rows =
          static_cast<std::size_t>(rows_per_stage) + problem.output_times.size() + plan->breaks().size() + 16;
      history.ledger.reserve(history.ledger.size() + rows);
      history.motion.reserve(history.motion.size() + rows);
    }
  }

  void watch() {
    const typename RunGuard<dim>::Spent cpu{history.cpu_seconds, cpu_start};
    guard = std::make_unique<RunGuard<dim>>(*plan, cpu, [&p = *plan] { return estimate(p).steps; });
    // Sorted: a rain record may have 1e5 rows.
    breaks = plan->breaks();
    std::sort(breaks.begin(), breaks.end());
    events = problem.output_times;
    events.insert(events.end(), breaks.begin(), breaks.end());
    std::sort(events.begin(), events.end());
  }

  double next_event() const {
    const auto next = std::upper_bound(events.begin(), events.end(), time);
    return next == events.end() ? plan->stage.end_time : std::min(*next, plan->stage.end_time);
  }

  void set_clock() {
    Clock& clock = plan->clock;
    clock.time = time;
    clock.event = next_event();
    clock.broken = time == plan->begin_time() || std::binary_search(breaks.begin(), breaks.end(), time);
    const double rest = clock.event - time, wanted = plan->propose_step();
    if (!(wanted > 1e-14 * std::max(1.0, clock.event)))
      throw StepFailed("the time step has shrunk to " + std::to_string(wanted) + " s");
    // The last two steps before an event share what is left, so that none is a splinter.
    clock.end = wanted >= rest * (1 - 1e-9) ? clock.event : time + (2 * wanted > rest ? rest / 2 : wanted);
    clock.dt = clock.end - clock.time;
  }

  void step() {
    if (finished()) return;
    double& steps = history.counters["steps"];
    try {
      guard->before_step(static_cast<long>(steps));
      set_clock();
      plan->run_step();
      guard->after_step(static_cast<long>(steps));
    } catch (const StepFailed& failure) {
      const std::string message =
          "t = " + std::to_string(time) + " s, stage '" + plan->stage.name + "': " + failure.what();
      history.log.push_back(message);
      throw GaveUp(message, finished_history());
    }
    time = plan->clock.end;
    steps += 1;
    const bool event = time >= plan->clock.event;
    const double interval = (plan->stage.end_time - plan->begin_time()) / rows_per_stage;
    if (event || !plan->conditionally_stable() || time - recorded_until >= interval) record();
    write_snapshot();
    if (time >= plan->stage.end_time && !finished()) change_stage();
  }

  void change_stage() {
    plan->finish(history);
    guard->tell(history);
    ++stage;
    try {
      enter_stage();
    } catch (const CannotPlan& refused) {
      history.cpu_seconds += thread_cpu_seconds() - cpu_start;
      throw GaveUp("t = " + std::to_string(time) + " s: " + refused.what(), history);
    }
  }

  void record() {
    recorded_until = time;
    if (const Column* ledger = fields.run.find("water ledger")) {
      const auto entry = [ledger](int component) { return (*ledger)[component][0]; };
      history.ledger.push_back({time, entry(ledger_rain_asked), entry(ledger_infiltrated), entry(ledger_run_off),
                                entry(ledger_outflow), entry(ledger_stored), entry(ledger_stored_points)});
    }
    plan->record(time, history);
  }

  void write_snapshot() {
    if (!std::binary_search(problem.output_times.begin(), problem.output_times.end(), time)) return;
    meshes::Snapshot snapshot;
    snapshot.time = time;
    snapshot.stage = plan->stage.name;
    for (const Block& block : fields.points.blocks())
      for (std::size_t p = block.first; p < block.first + block.count; ++p) {
        meshes::Point x{};
        std::ranges::copy(fields.points.position(p), x.begin());
        snapshot.points.position.push_back(x);
      }
    plan->output(snapshot);
    history.snapshots.push_back(std::move(snapshot));
  }

  meshes::FieldHistory finished_history() const {
    meshes::FieldHistory result = history;
    plan->finish(result);
    guard->tell(result);
    result.cpu_seconds += thread_cpu_seconds() - cpu_start;
    return result;
  }

  State state() const {
    State state{time, stage, {}, finished_history()};
    const auto store = [&state](const ColumnSet& set, const std::string& kind, const auto& values_of) {
      for (const auto& column : set.all())
        if (column->spec().lifetime == Lifetime::carried && column->allocated())
          state.fields[kind + "." + column->spec().name] = values_of(*column);
    };
    const auto all = [](const Column& c) { return std::vector<double>(c.values().begin(), c.values().end()); };
    store(fields.points.columns, "point", [this](const Column& c) { return fields.points.in_order(c); });
    store(fields.grid.columns, "node", all);
    store(fields.run, "run", all);
    const auto& counts = fields.points.count_of_cell();
    state.fields["points per cell"].assign(counts.begin(), counts.end());
    state.fields["recorded until"] = {recorded_until};
    return state;
  }
};

template <int dim>
Simulation<dim>::Simulation(const Problem<dim>& problem) : implementation_(std::make_unique<Implementation>(problem)) {}
template <int dim>
Simulation<dim>::Simulation(const Problem<dim>& problem, const State& state)
    : implementation_(std::make_unique<Implementation>(problem, state)) {}
template <int dim>
Simulation<dim>::~Simulation() = default;
template <int dim>
Simulation<dim>::Simulation(Simulation&&) noexcept = default;

template <int dim>
bool Simulation<dim>::finished() const {
  return implementation_->finished();
}
template <int dim>
void Simulation<dim>::step() {
  implementation_->step();
}
template <int dim>
double Simulation<dim>::time() const {
  return implementation_->time;
}
template <int dim>
State Simulation<dim>::state() const {
  return implementation_->state();
}
template <int dim>
meshes::FieldHistory Simulation<dim>::take_history() {
  return implementation_->finished_history();
}

template <int dim>
meshes::FieldHistory run(const Problem<dim>& problem, meshes::Progress progress) {
  Simulation<dim> simulation(problem);
  const double end = problem.stages.back().end_time;
  for (long steps = 0; !simulation.finished(); ++steps) {
    simulation.step();
    if (progress != nullptr && steps % 64 == 0) progress(simulation.time(), end, "mpm");
  }
  return simulation.take_history();
}

template class Simulation<2>;
template class Simulation<3>;
template meshes::FieldHistory run(const Problem<2>&, meshes::Progress);
template meshes::FieldHistory run(const Problem<3>&, meshes::Progress);

}  // namespace wetfront::mpm
