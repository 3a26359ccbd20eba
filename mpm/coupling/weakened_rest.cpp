#include "mpm/coupling/weakened_rest.h"

#include "mpm/coupling/water_pull.h"

#include <algorithm>

namespace wetfront::mpm {

template <int dim>
void WeakenedRest<dim>::join(StagePlan<dim>& plan) {
  if (plan.stage.liquid) {
    plan.provide_on_points({"pore stress", "chi p", "Pa"});
    plan.provide_on_points({"water", "W", dim == 2 ? "m2" : "m3"});
    plan.provide_on_nodes({"pressure", "p", "Pa"});  // contact looks at it
    if (std::ranges::any_of(plan.problem.soils, strengthened_by_suction))
      plan.provide_on_points({"suction", "chi s", "Pa"});
    cycle_->conditions.push_back(std::make_unique<WaterPull<dim>>(plan));
  }
  relaxer_ = std::make_unique<Relaxer<dim>>(plan, cycle_);
  add_relaxation<dim>(plan, [this] { return relaxer_->run_weakened(); });
}

template class WeakenedRest<2>;
template class WeakenedRest<3>;

}  // namespace wetfront::mpm
