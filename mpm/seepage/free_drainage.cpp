#include "mpm/seepage/free_drainage.h"

#include "mpm/boundary/outlets.h"
#include "mpm/laws/soil_water.h"

namespace wetfront::mpm {

namespace {

/// area . T g: what gravity pulls through a face of soil with permeability k T.
template <std::size_t dim>
double pull(const std::array<double, dim>& area, const std::array<double, 6>& t, const std::array<double, dim>& g) {
  if constexpr (dim == 2)
    return area[0] * (t[0] * g[0] + t[3] * g[1]) + area[1] * (t[3] * g[0] + t[1] * g[1]);
  else
    return area[0] * (t[0] * g[0] + t[3] * g[1] + t[5] * g[2]) + area[1] * (t[3] * g[0] + t[1] * g[1] + t[4] * g[2]) +
           area[2] * (t[5] * g[0] + t[4] * g[1] + t[2] * g[2]);
}

}  // namespace

template <int dim>
void FreeDrainage<dim>::drain(StagePlan<dim>& plan, int condition) {
  const auto& side = std::get<FreeDrainageSide>(plan.problem.water_boundary[static_cast<std::size_t>(condition)]);
  if (side.side == free_surface)
    throw CannotPlan(side.origin +
                     ": free drainage is asked for on the free surface (water drains out of the soil below, "
                     "not into the sky). Name a side of the mesh");
  const Problem<dim>& problem = plan.problem;
  const auto found = outlets(plan, water_->surface(plan), side.side, "free drainage", side.origin);
  for (std::size_t r = 0; r < problem.soils.size(); ++r) {
    std::vector<std::pair<int, double>> drains;  // node, integral of rho (T g).n
    for (const auto& outlet : found) {
      double weight = problem.conductivity_factor.empty() ? 1 : problem.conductivity_factor[outlet.cell];
      weight *= problem.water->density * pull(outlet.area, problem.soils[r].anisotropy, problem.gravity);
      if (static_cast<std::size_t>(outlet.region) == r && weight > 0) drains.emplace_back(outlet.node[0], weight);
    }
    if (drains.empty()) continue;
    with_soil_water(problem.soils[r], *problem.water, [&](const auto& laws) {
      const auto body = [this, laws, drains, condition] {
        for (const auto& [node, weight] : drains) {
          const ValueAndSlope relative = laws.permeability(laws.curve, -(*water_->trial)[0][node]);
          const double scale = weight * laws.saturated_mobility;
          (*water_->inflow)[0][node] -= scale * relative.value;
          (*water_->outflow)[0][node] += scale * relative.value;
          water_->add_to_side(condition, side_outflow, scale * relative.value);
          water_->add_slope(node, scale * relative.slope);
        }
      };
      water_->terms.push_back(&plan.add_iterated(Phase::pressure, "free drainage [" + side.side + "]", body));
    });
  }
}

template <int dim>
void FreeDrainage<dim>::join(StagePlan<dim>& plan) {
  plan.require_on_run("gravity");
  water_->keep_side_ledger(plan);
  for (std::size_t c = 0; c < plan.problem.water_boundary.size(); ++c)
    if (std::holds_alternative<FreeDrainageSide>(plan.problem.water_boundary[c])) drain(plan, static_cast<int>(c));
}

template class FreeDrainage<2>;
template class FreeDrainage<3>;

}  // namespace wetfront::mpm
