#include "mpm/seepage/periodic.h"

#include "mpm/boundary/skeleton_side.h"

#include <algorithm>

namespace wetfront::mpm {

template <int dim>
void Periodic<dim>::join(StagePlan<dim>& plan) {
  std::vector<std::array<std::string, 2>> sides;
  Origin origin;
  for (const auto& boundary : plan.problem.water_boundary)
    if (const auto* one = std::get_if<PeriodicSides>(&boundary)) {
      if (sides.empty()) origin = one->origin;
      sides.push_back({one->side, one->partner});
    }
  for (const auto& group : tied_nodes(plan.problem.mesh, sides, origin))
    for (std::size_t k = 1; k < group.size(); ++k) water_->ties.pairs.push_back({group[k], group.front()});
  std::sort(water_->ties.pairs.begin(), water_->ties.pairs.end(),
            [](const auto& one, const auto& other) { return one.node < other.node; });
  // A node held on one side only is held on both.
  auto& held = water_->held;
  const auto holding = [&held](int node) {
    return std::find_if(held.begin(), held.end(), [node](const auto& h) { return h.node == node; });
  };
  for (const auto& [node, other] : water_->ties.pairs)
    for (const auto& [known, open] : {std::pair{node, other}, std::pair{other, node}})
      if (holding(known) != held.end() && holding(open) == held.end()) {
        auto copy = *holding(known);
        copy.node = open;
        held.push_back(copy);
      }
}

template class Periodic<2>;
template class Periodic<3>;

}  // namespace wetfront::mpm
