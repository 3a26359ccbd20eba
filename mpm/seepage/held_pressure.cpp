#include "mpm/seepage/held_pressure.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/boundary/outlets.h"
#include "mpm/boundary/time_record.h"

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {

namespace {

/// p of a condition at a node.
template <int dim>
double pressure_at(const Problem<dim>& problem, const WaterBoundary& condition, int node, double end) {
  const auto index = static_cast<std::size_t>(node);
  if (const auto* head = std::get_if<TotalHeadSide>(&condition)) {
    const Vector<dim> up = upward(problem);
    double square = 0, z = 0;
    for (int a = 0; a < dim; ++a) {
      square += problem.gravity[a] * problem.gravity[a];
      z += problem.mesh.nodes[index][static_cast<std::size_t>(a)] * up[a];
    }
    return problem.water->density * std::sqrt(square) * (value_until(head->head, end) - z);
  }
  const auto& held = std::get<PressureSide>(condition);
  if (held.initial) return problem.initial_pressure[index];
  return held.record.time.empty() ? held.pressure : value_until(held.record, end);
}

}  // namespace

template <int dim>
void HeldPressure<dim>::hold(StagePlan<dim>& plan, int condition) {
  const auto& entry = plan.problem.water_boundary[static_cast<std::size_t>(condition)];
  const auto side = std::visit([](const auto& b) { return b.side; }, entry);
  const auto origin = std::visit([](const auto& b) { return b.origin; }, entry);
  for (const auto& outlet : outlets(plan, water_->surface(plan), side, "a prescribed pressure", origin)) {
    if (outlet.piece >= 0) continue;
    auto found = std::find_if(water_->held.begin(), water_->held.end(),
                              [&](const auto& held) { return held.node == outlet.node[0]; });
    if (found == water_->held.end()) found = water_->held.insert(found, {outlet.node[0], 0, condition});
    *found = {outlet.node[0], pressure_at(plan.problem, entry, outlet.node[0], plan.begin_time()), condition};
  }
}

template <int dim>
void HeldPressure<dim>::set_time(const StagePlan<dim>& plan, double end) {
  for (auto& held : water_->held)
    held.pressure = pressure_at(plan.problem, plan.problem.water_boundary[static_cast<std::size_t>(held.condition)],
                                held.node, end);
}

template <int dim>
void HeldPressure<dim>::join(StagePlan<dim>& plan) {
  plan.require_on_nodes("outflow");
  water_->keep_side_ledger(plan);
  bool moves = false;
  for (std::size_t c = 0; c < plan.problem.water_boundary.size(); ++c) {
    const auto& entry = plan.problem.water_boundary[c];
    const auto* pressure = std::get_if<PressureSide>(&entry);
    const bool head = std::holds_alternative<TotalHeadSide>(entry);
    if (pressure == nullptr && !head) continue;
    hold(plan, static_cast<int>(c));
    moves = moves || head || !pressure->record.time.empty();
  }
  if (moves) water_->before_solve.push_back([this, &plan](double, double end) { set_time(plan, end); });
}

template class HeldPressure<2>;
template class HeldPressure<3>;

}  // namespace wetfront::mpm
