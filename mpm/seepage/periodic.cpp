#include "mpm/seepage/periodic.h"

#include "mpm/boundary/boundary_side.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace wetfront::mpm {

namespace {

std::vector<int> nodes_of(const meshes::Mesh& mesh, const std::string& name, const Origin& origin) {
  for (const auto& side : mesh.sides)
    if (side.name == name) {
      const std::set<int> unique(side.faces.begin(), side.faces.end());
      return {unique.begin(), unique.end()};
    }
  throw CannotPlan(origin + ": periodic sides are asked for on '" + name +
                   "', which the mesh does not have. Its sides are " + side_names(mesh));
}

/// Lowest corner of the box around the nodes.
meshes::Point lowest(const meshes::Mesh& mesh, const std::vector<int>& nodes) {
  meshes::Point low;
  low.fill(std::numeric_limits<double>::infinity());
  for (int node : nodes)
    for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], mesh.nodes[static_cast<std::size_t>(node)][a]);
  return low;
}

/// Pairs (node of `side`, node of `partner`).
std::vector<std::pair<int, int>> pairs_of(const meshes::Mesh& mesh, const PeriodicSides& sides) {
  const auto here = nodes_of(mesh, sides.side, sides.origin), there = nodes_of(mesh, sides.partner, sides.origin);
  const auto from = lowest(mesh, here), to = lowest(mesh, there);
  double apart = 0;
  for (std::size_t a = 0; a < 3; ++a) apart = std::max(apart, std::abs(to[a] - from[a]));
  std::vector<std::pair<int, int>> pairs;
  for (int node : here) {
    const auto& x = mesh.nodes[static_cast<std::size_t>(node)];
    const auto partner = std::find_if(there.begin(), there.end(), [&](int other) {
      const auto& y = mesh.nodes[static_cast<std::size_t>(other)];
      double worst = 0;
      for (std::size_t a = 0; a < 3; ++a) worst = std::max(worst, std::abs((x[a] - from[a]) - (y[a] - to[a])));
      return worst <= 1e-6 * apart;  // mesh files hold six digits or more
    });
    if (partner != there.end() && *partner != node) pairs.emplace_back(node, *partner);
  }
  if (pairs.size() != here.size() || here.size() != there.size())
    throw CannotPlan(
        sides.origin + ": sides '" + sides.side + "' and '" + sides.partner +
        "' cannot be periodic (not every node of one has its image among the nodes of the other). Mesh both "
        "alike");
  return pairs;
}

}  // namespace

template <int dim>
void Periodic<dim>::join(StagePlan<dim>& plan) {
  const meshes::Mesh& mesh = plan.problem.mesh;
  std::vector<int> root(mesh.nodes.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](int node) {
    while (root[static_cast<std::size_t>(node)] != node) node = root[static_cast<std::size_t>(node)];
    return node;
  };
  for (const auto& boundary : plan.problem.water_boundary)
    if (const auto* sides = std::get_if<PeriodicSides>(&boundary))
      for (const auto& [node, partner] : pairs_of(mesh, *sides)) {
        const int a = find(node), b = find(partner);
        root[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
      }
  for (int node = 0; node < static_cast<int>(root.size()); ++node)
    if (find(node) != node) water_->ties.pairs.push_back({node, find(node)});
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
