#include "mpm/boundary/moving_side.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/boundary/skeleton_side.h"

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {

template <int dim>
MovingCondition<dim>::MovingCondition(StagePlan<dim>& plan, SkeletonCycle<dim>& cycle, const MovingSide& spec)
    : plan_(plan), cycle_(cycle), nodes_(plan), displacement_(plan.require_on_nodes("displacement")), spec_(spec) {
  for (double time : spec.factor.time) plan.add_break(time);
  boundary_side(plan, spec.side, "a motion", spec.origin);  // there is soil behind it
  // The whole side, also where no soil is yet: a body may slide along it.
  for (const auto& node : side_nodes(plan, spec.side, "a motion", spec.origin, false)) {
    index_.push_back(node.index);
    for (int a = 0; a < dim; ++a)
      if (spec.velocity[static_cast<std::size_t>(a)])
        cycle.fixed[static_cast<std::size_t>(a)].at(static_cast<std::size_t>(node.index)) = 1;
  }
}

template <int dim>
double MovingCondition<dim>::way(double time) const {
  const TimeRecord& factor = spec_.factor;
  if (factor.time.empty()) return time;
  double sum = 0, from = 0, before = factor.value.front();
  for (std::size_t k = 0; k < factor.time.size() && from < time; ++k) {
    const double until = std::min(factor.time[k], time);
    if (until > from) sum += 0.5 * (before + value_until(factor, until)) * (until - from);
    from = std::max(from, until);
    before = factor.value[k];
  }
  return sum + std::max(time - from, 0.0) * factor.value.back();
}

template <int dim>
double MovingCondition<dim>::velocity_now(int axis, std::size_t node) const {
  const double given = *spec_.velocity[static_cast<std::size_t>(axis)];
  if (plan_.stage.motion == SkeletonMotion::dynamic) return given * factor_at(spec_.factor, loading_time(plan_));
  const double most = std::abs(given) * std::abs(way(plan_.clock.end) - way(plan_.clock.time)) / 20;
  const double left = given * way(plan_.clock.end) - displacement_[axis][node];
  return std::clamp(left, -most, most) / cycle_.dt;
}

template <int dim>
bool MovingCondition<dim>::settled() const {
  if (plan_.stage.motion == SkeletonMotion::dynamic) return true;
  for (int a = 0; a < dim; ++a) {
    if (!spec_.velocity[static_cast<std::size_t>(a)]) continue;
    const double given = *spec_.velocity[static_cast<std::size_t>(a)], there = given * way(plan_.clock.end);
    const double step = std::abs(given) * std::abs(way(plan_.clock.end) - way(plan_.clock.time));
    for (int i : index_)
      if (const auto node = static_cast<std::size_t>(i);
          !nodes_.empty(node) && std::abs(there - displacement_[a][node]) > 1e-9 * step)
        return false;
  }
  return true;
}

template <int dim>
void MovingCondition<dim>::limit_acceleration() {
  for (int a = 0; a < dim; ++a) {
    if (!spec_.velocity[static_cast<std::size_t>(a)]) continue;
    for (int i : index_) {
      const auto node = static_cast<std::size_t>(i);
      if (nodes_.empty(node)) continue;
      nodes_.acceleration[a][node] = (velocity_now(a, node) - nodes_.velocity[a][node]) / cycle_.dt;
    }
  }
}

template <int dim>
void MovingCondition<dim>::limit_velocity() {
  for (int a = 0; a < dim; ++a) {
    if (!spec_.velocity[static_cast<std::size_t>(a)]) continue;
    for (int i : index_)
      if (const auto node = static_cast<std::size_t>(i); !nodes_.empty(node))
        nodes_.velocity[a][node] = velocity_now(a, node);
  }
}

template class MovingCondition<2>;
template class MovingCondition<3>;

}  // namespace wetfront::mpm
