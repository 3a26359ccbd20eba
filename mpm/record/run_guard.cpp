#include "mpm/record/run_guard.h"

#include "mpm/boundary/boundary_side.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace wetfront::mpm {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// A scan reads every carried number once: at one step in so many it costs well below a hundredth of the step.
constexpr long steps_between_scans = 16;
/// Reading the CPU clock costs 0.3 us, a small explicit step 3 us.
constexpr long steps_between_budgets = 16;
/// Crawling: at the pace of this many steps, the rest of the stage would need more than `most_steps`, ten million (an
/// hour of the smallest problems) or a hundred times what the plan expects.
constexpr long crawl_window = 1000;
constexpr double most_steps = 1e7, most_over_plan = 100;

template <class... Numbers>
std::string text_of(const char* format, Numbers... numbers) {
  char text[240];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

/// Sum of v * 0: zero unless one is not finite. Four sums, so that the additions do not wait for each other.
bool all_finite(std::span<const double> values) {
  double sum[4]{};
  std::size_t i = 0;
  for (; i + 4 <= values.size(); i += 4)
    for (std::size_t k = 0; k < 4; ++k) sum[k] += values[i + k] * 0.0;
  for (; i < values.size(); ++i) sum[0] += values[i] * 0.0;
  return sum[0] + sum[1] + sum[2] + sum[3] == 0.0;
}

/// x lies above the line, which is level beyond its ends.
bool above(const std::vector<meshes::Point>& line, const meshes::Point& x) {
  if (line.empty()) return false;
  std::size_t k = 0;
  while (k < line.size() && line[k][0] < x[0]) ++k;
  if (k == 0 || k == line.size()) return x[1] > (k == 0 ? line.front() : line.back())[1];
  const double part = (x[0] - line[k - 1][0]) / (line[k][0] - line[k - 1][0]);
  return x[1] > line[k - 1][1] + part * (line[k][1] - line[k - 1][1]);
}

/// Total heads times rho g [Pa] that the scene can produce.
template <int dim>
struct HeadRange {
  double lowest = infinity, highest = -infinity;

  explicit HeadRange(const Problem<dim>& problem) : problem_(problem), up_(upward(problem)) {
    weight_ = problem.water->density * length<dim>(problem.gravity);
    for (std::size_t i = 0; i < problem.mesh.node_count(); ++i) {
      take(problem.initial_pressure[i] + potential(i));
      top_ = std::max(top_, potential(i));
      base_ = std::min(base_, potential(i));
    }
    lowest_start_ = lowest;
    highest_pressure_ = *std::max_element(problem.initial_pressure.begin(), problem.initial_pressure.end());
    for (const auto& boundary : problem.water_boundary) std::visit([this](const auto& b) { add(b); }, boundary);
  }

  /// rho g times elevation [Pa].
  double potential(std::size_t node) const {
    double z = 0;
    for (int a = 0; a < dim; ++a) z += problem_.mesh.nodes[node][static_cast<std::size_t>(a)] * up_[a];
    return weight_ * z;
  }
  /// From the highest to the lowest head of the start or the base.
  double spread() const { return highest - std::min(lowest_start_, base_); }

 private:
  void take(double head) {
    lowest = std::min(lowest, head);
    highest = std::max(highest, head);
  }
  void add(const RainSide& rain) {
    highest = std::max(highest, top_);  // ponded: p = 0
    lowest = std::min(lowest, base_);   // a seepage face drains to p = 0
    if (!rain.evaporation.start.empty()) lowest = -infinity;
  }
  void add(const PressureSide& side) {
    if (side.initial) return;
    std::vector<double> pressures = side.record.value.empty() ? std::vector<double>{side.pressure} : side.record.value;
    for (double p : pressures) take(p + top_), take(p + base_);
  }
  void add(const TotalHeadSide& side) {
    for (double head : side.head.value) take(weight_ * head);
  }
  void add(const WaterLevelSide& side) {
    for (double level : side.level.value) take(weight_ * level);
    highest = std::max(highest, top_);
  }
  void add(const FluxSide&) {
    highest = std::max(highest, top_);
    lowest = -infinity;
  }
  void add(const FreeDrainageSide&) { lowest = -infinity; }
  void add(const PeriodicSides&) {
    // Pressures are equal on both sides, heads are not: as if the body were as deep as the mesh is high everywhere.
    highest = std::max(highest, std::max(highest_pressure_, 0.0) + top_ + (top_ - base_));
    lowest = -infinity;
  }

  const Problem<dim>& problem_;
  Vector<dim> up_;
  double weight_ = 0, top_ = -infinity, base_ = infinity, highest_pressure_ = 0, lowest_start_ = 0;
};

}  // namespace

template <int dim>
RunGuard<dim>::RunGuard(const StagePlan<dim>& plan, Spent cpu, std::function<double()> steps_expected)
    : plan_(plan), cpu_(cpu), steps_expected_(std::move(steps_expected)), most_steps_(most_steps) {
  const Problem<dim>& problem = plan.problem;
  const bool rigid =
      std::none_of(problem.soils.begin(), problem.soils.end(), [](const Soil& soil) { return soil.elastic; });
  if (!problem.water || !rigid) return;
  const HeadRange<dim> range(problem);
  constexpr double least = 1000;  // Pa; the range may be zero
  slack_ = least + 0.5 * range.spread();
  for (std::size_t i = 0; i < problem.mesh.node_count(); ++i) {
    // Above a surface inside cells a node has no soil around it: its pressure continues the gradient there, no more.
    const bool outside = above(problem.surface, problem.mesh.nodes[i]);
    highest_.push_back(outside ? infinity : range.highest - range.potential(i));
    lowest_.push_back(outside ? -infinity : range.lowest - range.potential(i));
  }
  energy_per_water_ = range.spread();
}

template <int dim>
void RunGuard<dim>::before_step(long steps_taken) {
  if (steps_taken % steps_between_budgets == 0 || !plan_.conditionally_stable()) check_budget();
  if (steps_taken % crawl_window == 0) check_crawl();
}

template <int dim>
void RunGuard<dim>::after_step(long steps_taken) {
  const Column* ledger = plan_.fields.run.find_allocated("water ledger");
  const bool sound = ledger == nullptr || all_finite(ledger->values());
  if (sound && steps_taken % steps_between_scans != 0 && plan_.conditionally_stable()) return;
  check_finite();
  check_heads();
  check_kinetic_energy();
}

template <int dim>
void RunGuard<dim>::check_budget() const {
  const double budget = plan_.problem.cpu_budget;
  if (!(budget > 0)) return;
  const double spent = cpu_.before + thread_cpu_seconds() - cpu_.since;
  if (spent <= budget) return;
  const double begin = plan_.begin_time(), end = plan_.stage.end_time;
  throw StepFailed(
      text_of("the run has taken %.3g s of CPU, its budget is %.3g s. The stage is %.3g %% done and steps of "
              "%.3g s; ",
              spent, budget, 100 * (plan_.clock.end - begin) / (end - begin), plan_.clock.dt) +
      where_time_went());
}

template <int dim>
void RunGuard<dim>::check_crawl() {
  const double now = plan_.clock.end, before = std::exchange(window_start_, now);
  if (before < 0) return;  // the first window of this process
  const double rest = plan_.stage.end_time - now, step = (now - before) / crawl_window;
  if (rest <= most_steps_ * step) return;
  most_steps_ = std::max(most_steps_, most_over_plan * steps_expected_());
  if (rest <= most_steps_ * step) return;
  throw StepFailed(
      text_of("the run crawls: the last %ld steps were %.3g s on average, %.3g such steps are left (limit of "
              "stability %.3g s); ",
              crawl_window, step, rest / step, plan_.stable_step()) +
      where_time_went());
}

template <int dim>
std::string RunGuard<dim>::where_time_went() const {
  meshes::FieldHistory history;
  plan_.finish(history);
  std::sort(history.cost.begin(), history.cost.end(),
            [](const auto& a, const auto& b) { return a.cpu_seconds > b.cpu_seconds; });
  double total = 0;
  for (const auto& kernel : history.cost) total += kernel.cpu_seconds;
  std::string text = "time went to";
  for (std::size_t k = 0; k < std::min<std::size_t>(3, history.cost.size()); ++k)
    text += text_of("%s %s %.0f %%", k == 0 ? "" : ",", history.cost[k].kernel.c_str(),
                    100 * history.cost[k].cpu_seconds / total);
  return text;
}

template <int dim>
void RunGuard<dim>::check_finite() const {
  const auto look = [this](const ColumnSet& set, const char* kind) {
    for (const auto& column : set.all()) {
      if (column->spec().lifetime != Lifetime::carried || !column->allocated() || all_finite(column->values()))
        continue;
      std::size_t at = 0;
      while (std::isfinite(column->values()[at])) ++at;
      stop(column->spec().name + " is not a number", kind, at % column->size());
    }
  };
  look(plan_.fields.points.columns, "point");
  look(plan_.fields.grid.columns, "node");
  look(plan_.fields.run, "run");
}

template <int dim>
void RunGuard<dim>::check_heads() {
  const Column* pressure = plan_.fields.grid.columns.find_allocated("pressure");
  if (highest_.empty() || pressure == nullptr) return;
  const double* p = (*pressure)[0];
  for (std::size_t i = 0; i < highest_.size(); ++i) {
    const double beyond = std::max(p[i] - highest_[i], lowest_[i] - p[i]);
    if (beyond > slack_)
      stop(text_of("pressure is %.4g Pa, where the heads of this scene leave %.4g to %.4g Pa", p[i], lowest_[i],
                   highest_[i]),
           "node", i);
    beyond_ = std::max(beyond_, beyond);
  }
}

template <int dim>
void RunGuard<dim>::tell(meshes::FieldHistory& history) const {
  if (highest_.empty()) return;
  double& worst = history.counters["pressure beyond heads [Pa]"];
  worst = std::max(worst, beyond_);
}

template <int dim>
void RunGuard<dim>::check_kinetic_energy() const {
  const ColumnSet& points = plan_.fields.points.columns;
  const Column *water = points.find_allocated("water"), *velocity = points.find_allocated("liquid velocity");
  if (highest_.empty() || water == nullptr || velocity == nullptr) return;
  double energy = 0, volume = 0;
  for (std::size_t q = 0; q < water->size(); ++q) {
    double square = 0;
    for (int a = 0; a < dim; ++a) square += (*velocity)[a][q] * (*velocity)[a][q];
    energy += (*water)[0][q] * square;
    volume += (*water)[0][q];
  }
  energy *= 0.5 * plan_.problem.water->density;
  if (energy <= energy_per_water_ * volume) return;
  throw StepFailed(
      text_of("the liquid moves with %.3g J, the heads of this scene can give it %.3g J (the scheme has "
              "blown up; dt = %.3g s, limit of stability %.3g s). Use a smaller step_safety",
              energy, energy_per_water_ * volume, plan_.clock.dt, plan_.stable_step()));
}

template <int dim>
void RunGuard<dim>::stop(const std::string& what, const char* kind, std::size_t at) const {
  std::string place;
  const auto say = [&](const auto& x) {
    place = text_of(dim == 2 ? " (x = %.4g, %.4g m)" : " (x = %.4g, %.4g, %.4g m)", x[0], x[1], x[dim - 1]);
  };
  if (std::string(kind) == "node") say(plan_.fields.grid.node(static_cast<int>(at)));
  if (std::string(kind) == "point") say(plan_.fields.points.position(at));
  throw StepFailed(text_of("%s %zu%s: ", kind, at, place.c_str()) + what +
                   text_of(" (the scheme has blown up; dt = %.3g s, limit of stability %.3g s). Use a smaller "
                           "step_safety, or the scheme seepage",
                           plan_.clock.dt, plan_.stable_step()));
}

template class RunGuard<2>;
template class RunGuard<3>;

}  // namespace wetfront::mpm
