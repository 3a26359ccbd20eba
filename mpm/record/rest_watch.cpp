#include "mpm/record/rest_watch.h"

#include "mpm/grid/point_sums.h"

#include <algorithm>

namespace wetfront::mpm {

template <int dim>
void RestWatch<dim>::join(StagePlan<dim>& plan) {
  const Column &mass = plan.require_on_points("mass"), &velocity = plan.require_on_points("velocity");
  Column& watch = plan.provide_on_run({"rest watch", "E", "J, s, -", rest_entries});
  plan.at_begin([&plan, &watch] {
    watch.fill(0);
    watch[rest_loud][0] = plan.begin_time();
  });
  plan.add(Phase::carry, "rest watch", [&plan, &mass, &velocity, &watch] {
    const auto& points = plan.fields.points;
    const double energy = kinetic_energy(points, mass, velocity);
    const double whole = over_points(points, [&mass](std::size_t p) { return mass[0][p]; });
    const RestCriterion& rest = plan.stage.rest;
    const double slow = 0.5 * whole * rest.slowest * rest.slowest;
    watch[rest_largest][0] = std::max(watch[rest_largest][0], energy);
    const double largest = watch[rest_largest][0];
    if (energy > std::max(rest.energy_ratio * largest, slow)) watch[rest_loud][0] = plan.clock.end;
    const bool has_moved = largest > 100 * slow;
    watch[rest_reached][0] = has_moved && plan.clock.end - watch[rest_loud][0] >= rest.hold ? 1 : 0;
  });
}

template class RestWatch<2>;
template class RestWatch<3>;

}  // namespace wetfront::mpm
