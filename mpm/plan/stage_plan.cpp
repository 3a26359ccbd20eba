#include "mpm/plan/stage_plan.h"

#include "mpm/grid/seeding.h"
#include "mpm/grid/spline_grid.h"

#include <algorithm>
#include <limits>

namespace wetfront::mpm {

template <int dim>
Fields<dim>::Fields(const Problem<dim>& problem)
    : grid(problem.mesh), points(seed<dim>(grid, problem.points_per_cell, problem.surface, problem.empty_cells)) {
  const auto deforms = [](const Soil& soil) { return soil.elastic.has_value(); };
  if (std::none_of(problem.soils.begin(), problem.soils.end(), deforms)) return;
  points.make_room(grid);
  // Splines have nodes of their own: columns of nodes are then as long as there are splines.
  if (problem.skeleton.shape == ShapeFunctions::quadratic_spline)
    grid.columns.resize(SplineGrid<dim>(problem.mesh).node_count());
}

template <int dim>
StagePlan<dim>::StagePlan(const Problem<dim>& problem_, std::size_t stage_index, Fields<dim>& fields_)
    : problem(problem_), stage(problem_.stages.at(stage_index)), fields(fields_), stage_index_(stage_index) {
  for (ColumnSet* set : {&fields.points.columns, &fields.grid.columns, &fields.run}) set->begin_plan();
  joining_ = "material points";
  provide_on_points({"position", "x", "m", dim});
  provide_on_points({"volume", "V", dim == 2 ? "m2" : "m3"});
}

template <int dim>
void StagePlan<dim>::join(std::unique_ptr<Effect<dim>> effect) {
  joining_ = effect->name();
  effects_.push_back(std::move(effect));
  effects_.back()->join(*this);
}

template <int dim>
Column& StagePlan<dim>::require(ColumnSet& set, const std::string& name) {
  requirements_.push_back({&set, name, joining_});
  return set.require(name);
}

template <int dim>
Kernel& StagePlan<dim>::add(Phase phase, const std::string& name, std::function<void()> body) {
  const auto later =
      std::find_if(kernels_.begin(), kernels_.end(), [phase](const auto& k) { return k->phase() > phase; });
  return **kernels_.insert(later, std::make_unique<Kernel>(phase, name, joining_, std::move(body)));
}

template <int dim>
Kernel& StagePlan<dim>::add_iterated(Phase phase, const std::string& name, std::function<void()> body) {
  iterated_.push_back(std::make_unique<Kernel>(phase, name, joining_, std::move(body)));
  return *iterated_.back();
}

template <int dim>
void StagePlan<dim>::add_stability_limit(const std::string& name, const std::string& formula,
                                         std::function<double()> seconds) {
  limits_.push_back({name, formula, std::move(seconds), true});
}

template <int dim>
void StagePlan<dim>::add_accuracy_limit(const std::string& name, const std::string& formula,
                                        std::function<double()> seconds) {
  limits_.push_back({name, formula, std::move(seconds), false});
}

template <int dim>
void StagePlan<dim>::check() const {
  for (const Requirement& need : requirements_) {
    const Column* column = need.set->find(need.column);
    if (column == nullptr || column->provided_by().empty())
      throw CannotPlan(need.effect + " needs '" + need.column + "' but no effect of this scene provides it (stage '" +
                       stage.name + "')");
  }
}

template <int dim>
void StagePlan<dim>::enter() {
  check();
  for (ColumnSet* set : {&fields.points.columns, &fields.grid.columns, &fields.run}) set->allocate();
  for (auto& body : at_entry_) body();
  for (ColumnSet* set : {&fields.points.columns, &fields.grid.columns, &fields.run}) set->free_unprovided();
  try {
    for (auto& body : at_ready_) body();
    for (auto& body : at_begin_) body();
  } catch (const StepFailed& failure) {
    throw CannotPlan(stage.origin + ": stage '" + stage.name + "' cannot begin: " + failure.what());
  }
}

template <int dim>
void StagePlan<dim>::resume(const std::map<std::string, std::vector<double>>& stored) {
  check();
  const auto restore = [&stored](ColumnSet& set, const std::string& kind, std::size_t items, const auto& put) {
    set.allocate();
    set.free_unprovided();
    for (const auto& column : set.all()) {
      if (column->spec().lifetime != Lifetime::carried) continue;
      const auto found = stored.find(kind + "." + column->spec().name);
      const std::size_t length = items * static_cast<std::size_t>(column->spec().components);
      if (found == stored.end() || found->second.size() != length)
        throw CannotPlan("cannot continue this run: its state has no field '" + kind + "." + column->spec().name +
                         "' of the right length (it belongs to another problem). Start the run anew");
      put(found->second, *column);
    }
  };
  const auto copy = [](const std::vector<double>& from, Column& to) {
    std::copy(from.begin(), from.end(), to.values().begin());
  };
  restore(fields.points.columns, "point", fields.points.size(),
          [this](const std::vector<double>& from, Column& to) { fields.points.put_in_order(from, to); });
  restore(fields.grid.columns, "node", fields.grid.columns.size(), copy);
  restore(fields.run, "run", fields.run.size(), copy);
  for (auto& body : at_ready_) body();
}

template <int dim>
void StagePlan<dim>::run_step() {
  for (auto& kernel : kernels_) kernel->run();
}

template <int dim>
double StagePlan<dim>::propose_step() const {
  double step = stage.largest_step > 0 ? stage.largest_step : std::numeric_limits<double>::infinity();
  for (const Limit& limit : limits_)
    step = std::min(step, limit.seconds() * (limit.stability ? stage.step_safety : 1.0));
  return step;
}

template <int dim>
double StagePlan<dim>::stable_step() const {
  double step = std::numeric_limits<double>::infinity();
  for (const Limit& limit : limits_)
    if (limit.stability) step = std::min(step, limit.seconds() * stage.step_safety);
  return step;
}

template <int dim>
bool StagePlan<dim>::conditionally_stable() const {
  return std::any_of(limits_.begin(), limits_.end(), [](const Limit& limit) { return limit.stability; });
}

template <int dim>
void StagePlan<dim>::output(meshes::Snapshot& snapshot) const {
  for (const auto& body : at_output_) body(snapshot);
}

template <int dim>
void StagePlan<dim>::record(double time, meshes::FieldHistory& history) const {
  for (const auto& body : at_record_) body(time, history);
}

template <int dim>
void StagePlan<dim>::finish(meshes::FieldHistory& history) const {
  for (const auto& body : at_finish_) body(history);
  const auto add = [&history](const Kernel& kernel) {
    const auto same = [&](const meshes::KernelCost& cost) {
      return cost.phase == phase_name(kernel.phase()) && cost.kernel == kernel.name();
    };
    auto found = std::find_if(history.cost.begin(), history.cost.end(), same);
    if (found == history.cost.end())
      found = history.cost.insert(found, {phase_name(kernel.phase()), kernel.name(), 0.0, 0});
    found->cpu_seconds += kernel.cpu_seconds();
    found->calls += kernel.calls();
  };
  for (const auto& kernel : kernels_) add(*kernel);
  for (const auto& kernel : iterated_) add(*kernel);
}

template <int dim>
std::string StagePlan<dim>::scheme() const {
  std::string text;
  for (const auto& effect : effects_) text += (text.empty() ? "" : " + ") + effect->name();
  return text;
}

template class StagePlan<2>;
template class StagePlan<3>;
template struct Fields<2>;
template struct Fields<3>;

}  // namespace wetfront::mpm
