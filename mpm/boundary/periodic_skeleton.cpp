#include "mpm/boundary/periodic_skeleton.h"

#include "mpm/boundary/skeleton_side.h"

namespace wetfront::mpm {

template <int dim>
PeriodicCondition<dim>::PeriodicCondition(StagePlan<dim>& plan, const std::vector<PeriodicSkeleton>& sides)
    : nodes_(plan) {
  std::vector<std::array<std::string, 2>> pairs;
  for (const PeriodicSkeleton& side : sides) pairs.push_back({side.side, side.partner});
  groups_ = tied_nodes(plan.problem.mesh, pairs, sides.front().origin);
}

template <int dim>
double PeriodicCondition<dim>::mass_of(const std::vector<int>& group) const {
  double mass = 0;
  for (int node : group) mass += nodes_.mass[0][node];
  return mass;
}

template <int dim>
void PeriodicCondition<dim>::share(Column& column) const {
  for (const auto& group : groups_) {
    const double mass = mass_of(group);
    if (!(mass > 0)) continue;
    for (int a = 0; a < dim; ++a) {
      double sum = 0;
      for (int node : group) sum += nodes_.mass[0][node] * column[a][node];
      for (int node : group) column[a][node] = nodes_.mass[0][node] > 0 ? sum / mass : 0.0;
    }
  }
}

template <int dim>
void PeriodicCondition<dim>::see_force() {
  share(nodes_.velocity);
  for (const auto& group : groups_) {
    const double mass = mass_of(group);
    if (!(mass > 0)) continue;
    for (int a = 0; a < dim; ++a) {
      double sum = 0;
      for (int node : group) sum += nodes_.force[a][node];
      for (int node : group) nodes_.force[a][node] = sum * nodes_.mass[0][node] / mass;
    }
  }
}

template <int dim>
void PeriodicCondition<dim>::limit_acceleration() {
  share(nodes_.acceleration);
}

template <int dim>
void PeriodicCondition<dim>::limit_velocity() {
  share(nodes_.velocity);
}

template class PeriodicCondition<2>;
template class PeriodicCondition<3>;

}  // namespace wetfront::mpm
