#include "mpm/simulation.h"

#include "mpm/coupling/skeleton_failed.h"
#include "mpm/plan/carried_state.h"
#include "mpm/plan/derive_effects.h"
#include "mpm/plan/estimate.h"
#include "mpm/record/pictures.h"
#include "mpm/record/rest_watch.h"
#include "mpm/record/run_guard.h"
#include "mpm/record/water_ledger.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace wetfront::mpm {

namespace {

/// A conditionally stable stage takes millions of steps: its ledger and gauges are written at events and at this many
/// even intervals. (An implicit stage writes every accepted step.)
constexpr double rows_per_stage = 4000;
/// Of a stage that ends with failure and asks for no pictures, if its time runs out.
constexpr double pictures_under_rain = 20;
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

template <int dim>
struct Simulation<dim>::Implementation {
  Problem<dim> problem;
  std::unique_ptr<Fields<dim>> fields;
  std::unique_ptr<StagePlan<dim>> plan;
  std::unique_ptr<RunGuard<dim>> guard;
  meshes::FieldHistory history;
  double time = 0, recorded_until = 0;
  double step_cap = infinity;  ///< after failed tries in a stage that ends with failure [s]
  bool over = false;           ///< an event has ended the run before its last stage
  std::size_t stage = 0;
  std::vector<double> breaks, pictures, events;  ///< of the stage; all of them, outputs too [s, ascending]
  double cpu_start = thread_cpu_seconds();

  explicit Implementation(const Problem<dim>& p)
      : problem((check(p), check_cost(p), p)), fields(std::make_unique<Fields<dim>>(problem)) {
    history.mesh = problem.mesh;
    enter_stage();
    record();
    write_snapshot();
    if (!pictures.empty() || unasked_interval() > 0) take_picture("");
  }

  Implementation(const Problem<dim>& p, const State& state)
      : problem((check(p), p)),
        fields(std::make_unique<Fields<dim>>(problem)),
        history(state.history),
        time(state.time),
        stage(state.stage) {
    fields->body = state.body;
    if (const auto ends = state.fields.find("stage ends");
        ends != state.fields.end() && ends->second.size() == problem.stages.size())
      for (std::size_t k = 0; k < problem.stages.size(); ++k) problem.stages[k].end_time = ends->second[k];
    const auto number = [&state](const char* name, double otherwise) {
      const auto found = state.fields.find(name);
      return found != state.fields.end() ? found->second.at(0) : otherwise;
    };
    recorded_until = number("recorded until", time);
    step_cap = number("step cap", infinity);
    over = number("over", 0) != 0;
    restore(state.fields);
  }

  /// Points, plan and columns as they were stored.
  void restore(const Stored& stored) {
    restore_points(*fields, stored);
    plan = make_plan(problem, stage, *fields);
    plan->resume(stored);
    watch();
  }

  bool finished() const {
    return over || (stage + 1 == problem.stages.size() && time >= problem.stages[stage].end_time);
  }

  void enter_stage() {
    plan = make_plan(problem, stage, *fields);
    plan->enter();
    watch();
    const std::string scheme = plan->scheme();
    history.solver += (history.solver.empty() ? "mpm: " : ", then ") + scheme;
    history.log.push_back("stage '" + plan->stage.name + "' begins: " + scheme);
    fields->body.stages.push_back({plan->stage.name, scheme, time, time});
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
    pictures.clear();
    if (const double every = plan->stage.picture_every; every > 0)
      for (double k = 0; plan->begin_time() + k * every <= plan->stage.end_time; ++k)
        pictures.push_back(plan->begin_time() + k * every);
    events = problem.output_times;
    for (const auto* more : {&breaks, &pictures}) events.insert(events.end(), more->begin(), more->end());
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
    const double rest = clock.event - time, wanted = std::min(step_cap, plan->propose_step());
    if (!(wanted > 1e-14 * std::max(1.0, clock.event)))
      throw StepFailed("the time step has shrunk to " + std::to_string(wanted) + " s");
    // The last two steps before an event share what is left, so that none is a splinter.
    clock.end = wanted >= rest * (1 - 1e-9) ? clock.event : time + (2 * wanted > rest ? rest / 2 : wanted);
    clock.dt = clock.end - clock.time;
  }

  void step() {
    if (finished()) return;
    double& steps = history.counters["steps"];
    const bool may_fail = plan->stage.ends_with == StageEnd::failure;
    const Stored kept = may_fail ? carried_state(*fields) : Stored{};
    try {
      guard->before_step(static_cast<long>(steps));
      set_clock();
      plan->run_step();
      guard->after_step(static_cast<long>(steps));
    } catch (const SkeletonFailed& failure) {
      if (may_fail) return take_back(kept, failure.what(), true);
      give_up(failure.what());
    } catch (const StepFailed& failure) {
      if (may_fail && plan->clock.dt > plan->stage.failure.shortest_step) return take_back(kept, failure.what(), false);
      give_up(failure.what());
    }
    time = plan->clock.end;
    step_cap *= 2;
    steps += 1;
    const bool event = time >= plan->clock.event;
    const double interval = (plan->stage.end_time - plan->begin_time()) / rows_per_stage;
    if (event || !plan->conditionally_stable() || time - recorded_until >= interval) record();
    write_snapshot();
    if (std::binary_search(pictures.begin(), pictures.end(), time) || unasked_picture_due()) take_picture("");
    look_for_end();
  }

  [[noreturn]] void give_up(const std::string& why) {
    const std::string message = "t = " + std::to_string(time) + " s, stage '" + plan->stage.name + "': " + why;
    history.log.push_back(message);
    throw GaveUp(message, finished_history());
  }

  /// No equilibrium in the step that was tried: back to its beginning, and half as far; at the shortest step: failure.
  void take_back(const Stored& kept, const std::string& why, bool failed) {
    const double tried = plan->clock.dt;
    plan->finish(history);
    guard->tell(history);
    history.counters["steps taken back"] += 1;
    BodyRecord body = std::move(fields->body);
    plan.reset();
    fields = std::make_unique<Fields<dim>>(problem);
    fields->body = std::move(body);
    restore(kept);
    step_cap = 0.5 * tried;
    if (!failed || step_cap >= plan->stage.failure.shortest_step) return;
    take_picture("failure");
    end_stage("failure", why);
  }

  void look_for_end() {
    const Stage& now = plan->stage;
    if (now.ends_with == StageEnd::rest && fields->run.at("rest watch")[rest_reached][0] != 0) {
      take_picture("rest");
      return end_stage("rest", "the kinetic energy has stayed below its limit");
    }
    if (time < now.end_time) return;
    if (now.ends_with == StageEnd::failure) {
      over = true;
      return end_stage("time", "it has not failed");
    }
    end_stage("time", now.ends_with == StageEnd::rest ? "it has not come to rest" : "");
  }

  void end_stage(const std::string& by, const std::string& reason) {
    char text[80];
    std::snprintf(text, sizeof text, "' ends at %.6g s: ", time);
    history.log.push_back("stage '" + plan->stage.name + text + (by == "time" ? "its time is over" : by) +
                          (reason.empty() ? "" : " (" + reason + ")"));
    StageSpan& span = fields->body.stages.back();
    span.end = time;
    span.ended_by = by;
    span.reason = reason;
    problem.stages[stage].end_time = time;
    if (over || stage + 1 == problem.stages.size()) return;
    for (std::size_t k = stage + 1; k < problem.stages.size(); ++k) {
      const double before = problem.stages[k - 1].end_time;
      if (problem.stages[k].longest > 0) problem.stages[k].end_time = before + problem.stages[k].longest;
    }
    change_stage();
  }

  void change_stage() {
    plan->finish(history);
    guard->tell(history);
    step_cap = infinity;
    do {
      ++stage;
      if (problem.stages[stage].end_time > time) break;
      history.log.push_back("stage '" + problem.stages[stage].name + "' is left out: its time is over");
    } while (stage + 1 < problem.stages.size());
    if (!(problem.stages[stage].end_time > time)) {
      over = true;
      return;
    }
    // A stage that is left out has no length: the next one begins now.
    for (std::size_t k = 0; k < stage; ++k) problem.stages[k].end_time = std::min(problem.stages[k].end_time, time);
    problem.stages[stage - 1].end_time = time;
    try {
      enter_stage();
    } catch (const CannotPlan& refused) {
      history.cpu_seconds += thread_cpu_seconds() - cpu_start;
      throw GaveUp("t = " + std::to_string(time) + " s: " + refused.what(), history);
    }
    if (!pictures.empty()) take_picture("");
  }

  void record() {
    recorded_until = time;
    if (const Column* ledger = fields->run.find("water ledger")) {
      const auto entry = [ledger](int component) { return (*ledger)[component][0]; };
      history.ledger.push_back({time, entry(ledger_rain_asked), entry(ledger_infiltrated), entry(ledger_run_off),
                                entry(ledger_outflow), entry(ledger_stored), entry(ledger_stored_points)});
    }
    plan->record(time, history);
  }

  void write_snapshot() {
    if (std::binary_search(problem.output_times.begin(), problem.output_times.end(), time))
      history.snapshots.push_back(snapshot_of(*plan, time));
  }

  /// Time between pictures that nobody asked for [s]; 0: none. They show what came before a failure.
  double unasked_interval() const {
    const Stage& now = plan->stage;
    if (dim != 2 || now.ends_with != StageEnd::failure || now.picture_every > 0) return 0;
    return (now.end_time - plan->begin_time()) / pictures_under_rain;
  }

  /// Whether the step that was taken went past the next of them; they steer no step.
  bool unasked_picture_due() const {
    const double every = unasked_interval();
    if (!(every > 0)) return false;
    const auto count = [&](double t) { return std::floor((t - plan->begin_time()) / every); };
    return count(plan->clock.end) > count(plan->clock.time);
  }

  void take_picture(const std::string& of) { fields->body.pictures.push_back(picture_of(*plan, time, of)); }

  meshes::FieldHistory finished_history() const {
    meshes::FieldHistory result = history;
    plan->finish(result);
    guard->tell(result);
    result.cpu_seconds += thread_cpu_seconds() - cpu_start;
    return result;
  }

  State state() const {
    State state{time, stage, carried_state(*fields), finished_history(), fields->body};
    state.fields["recorded until"] = {recorded_until};
    state.fields["step cap"] = {step_cap};
    state.fields["over"] = {over ? 1.0 : 0.0};
    for (const Stage& one : problem.stages) state.fields["stage ends"].push_back(one.end_time);
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
double Simulation<dim>::stage_end() const {
  return implementation_->problem.stages[implementation_->stage].end_time;
}
template <int dim>
double Simulation<dim>::end() const {
  return implementation_->problem.stages.back().end_time;
}
template <int dim>
const BodyRecord& Simulation<dim>::body() const {
  return implementation_->fields->body;
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
  for (long steps = 0; !simulation.finished(); ++steps) {
    simulation.step();
    if (progress != nullptr && steps % 64 == 0) progress(simulation.time(), simulation.end(), "mpm");
  }
  return simulation.take_history();
}

template class Simulation<2>;
template class Simulation<3>;
template meshes::FieldHistory run(const Problem<2>&, meshes::Progress);
template meshes::FieldHistory run(const Problem<3>&, meshes::Progress);

}  // namespace wetfront::mpm
