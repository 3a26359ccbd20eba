#include "mpm/plan.h"
#include "mpm/plan/derive_effects.h"
#include "mpm/plan/estimate.h"
#include "mpm/plan/stage_plan.h"

namespace wetfront::mpm {

template <int dim>
PlanInfo StagePlan<dim>::info() const {
  PlanInfo info;
  info.stage = stage.name;
  info.scheme = scheme();
  for (const auto& effect : effects_)
    info.effects.push_back({effect->name(), effect->called_for_by(), effect->equations()});
  for (const auto& column : fields.points.columns.all()) {
    if (!column->allocated()) continue;
    const ColumnSpec& spec = column->spec();
    const std::size_t bytes = column->values().size_bytes() / std::max<std::size_t>(1, column->size());
    info.columns.push_back({spec.name, spec.symbol, spec.unit, spec.components, spec.lifetime == Lifetime::carried,
                            bytes, column->provided_by()});
    info.bytes_per_point += bytes;
    info.point_bytes += column->values().size_bytes();
  }
  // Iterated kernels first within their phase: they run inside the kernel that closes the phase.
  for (int p = 0; p < phase_count; ++p)
    for (const auto* list : {&iterated_, &kernels_})
      for (const auto& kernel : *list)
        if (kernel->phase() == static_cast<Phase>(p))
          info.kernels.push_back({phase_name(kernel->phase()), kernel->name(), kernel->effect()});
  for (const Limit& limit : limits_) info.step_limits.push_back({limit.name, limit.formula, limit.seconds()});
  info.points = fields.points.size();
  info.slots = fields.points.slots();
  info.nodes = fields.grid.node_count();
  info.cells = fields.grid.cell_count();
  const StageEstimate cost = estimate(*this);
  info.estimated_steps = cost.steps;
  info.estimated_cpu_seconds = cost.cpu_seconds;
  return info;
}

template <int dim>
std::vector<PlanInfo> plan(const Problem<dim>& problem) {
  check(problem);
  check_cost(problem);
  Fields<dim> fields(problem);
  std::vector<PlanInfo> infos;
  // Entering stage after stage shows the columns of each, from the initial state: nothing is run.
  for (std::size_t stage = 0; stage < problem.stages.size(); ++stage) {
    const auto made = make_plan(problem, stage, fields);
    made->enter();
    infos.push_back(made->info());
  }
  return infos;
}

template PlanInfo StagePlan<2>::info() const;
template PlanInfo StagePlan<3>::info() const;
template std::vector<PlanInfo> plan(const Problem<2>&);
template std::vector<PlanInfo> plan(const Problem<3>&);

}  // namespace wetfront::mpm
