#include "mpm/boundary/skeleton_side.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/boundary/faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace wetfront::mpm {

namespace {

/// Faces whose normals differ by less than this (a microradian) lie in one plane: mesh files hold six digits or more.
constexpr double one_plane = 1 - 1e-12;

template <int dim>
void add_face(std::vector<SidePlane<dim>>& planes, const Vector<dim>& integral) {
  const double area = length<dim>(integral);
  if (!(area > 0)) return;
  Vector<dim> normal;
  for (int a = 0; a < dim; ++a) normal[a] = integral[a] / area;
  for (SidePlane<dim>& plane : planes)
    if (dot<dim>(plane.normal, normal) > one_plane) {
      plane.area += area;
      return;
    }
  planes.push_back({normal, area});
}

}  // namespace

template <int dim>
std::vector<SideNode<dim>> side_nodes(const StagePlan<dim>& plan, const std::string& side, const std::string& who,
                                      const Origin& origin, bool only_with_soil) {
  const meshes::Mesh& mesh = plan.problem.mesh;
  const Grid<dim>& grid = plan.fields.grid;
  const meshes::Side* named = &named_side(mesh, side, who, origin);
  if (plan.problem.skeleton.shape != ShapeFunctions::linear)
    throw CannotPlan(origin + ": " + who +
                     " is asked for with spline shape functions (sides know the nodes of the mesh, splines have "
                     "others). Use linear shape functions");
  const int number = static_cast<int>(named - mesh.sides.data());
  const Faces<dim> faces(grid, mesh);
  std::map<int, SideNode<dim>> found;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell)
    for (int face = 0; face < cell_faces<dim>; ++face) {
      if (faces.side(cell, face) != number || (only_with_soil && !plan.fields.points.occupied(cell))) continue;
      const auto local = local_face<dim>(face);
      const auto integrals = Faces<dim>::integrals(grid, cell, face);
      for (std::size_t i = 0; i < local.size(); ++i) {
        const int index = grid.cell_nodes_of(cell)[local[i]];
        const auto [node, fresh] = found.try_emplace(index, SideNode<dim>{index, grid.region(cell), {}});
        add_face<dim>(node->second.planes, integrals[i]);
      }
    }
  std::vector<SideNode<dim>> nodes;
  for (auto& [index, node] : found) nodes.push_back(std::move(node));
  return nodes;
}

namespace {

std::vector<int> nodes_of(const meshes::Mesh& mesh, const std::string& name, const Origin& origin) {
  const meshes::Side& side = named_side(mesh, name, "a periodic pair", origin);
  const std::set<int> unique(side.faces.begin(), side.faces.end());
  return {unique.begin(), unique.end()};
}

/// Lowest corner of the box around the nodes.
meshes::Point lowest(const meshes::Mesh& mesh, const std::vector<int>& nodes) {
  meshes::Point low;
  low.fill(std::numeric_limits<double>::infinity());
  for (int node : nodes)
    for (std::size_t a = 0; a < 3; ++a) low[a] = std::min(low[a], mesh.nodes[static_cast<std::size_t>(node)][a]);
  return low;
}

std::vector<std::pair<int, int>> pairs_of(const meshes::Mesh& mesh, const std::array<std::string, 2>& sides,
                                          const Origin& origin) {
  const auto here = nodes_of(mesh, sides[0], origin), there = nodes_of(mesh, sides[1], origin);
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
    throw CannotPlan(origin + ": sides '" + sides[0] + "' and '" + sides[1] +
                     "' cannot be periodic (not every node of one has its image among the nodes of the other). Mesh "
                     "both alike");
  return pairs;
}

}  // namespace

meshes::Point between_sides(const meshes::Mesh& mesh, const std::string& side, const std::string& partner,
                            const Origin& origin) {
  const auto from = lowest(mesh, nodes_of(mesh, side, origin)), to = lowest(mesh, nodes_of(mesh, partner, origin));
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

std::vector<std::vector<int>> tied_nodes(const meshes::Mesh& mesh, const std::vector<std::array<std::string, 2>>& sides,
                                         const Origin& origin) {
  std::vector<int> root(mesh.nodes.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](int node) {
    while (root[static_cast<std::size_t>(node)] != node) node = root[static_cast<std::size_t>(node)];
    return node;
  };
  for (const auto& pair : sides)
    for (const auto& [node, partner] : pairs_of(mesh, pair, origin)) {
      const int a = find(node), b = find(partner);
      root[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
  std::map<int, std::vector<int>> groups;
  for (int node = 0; node < static_cast<int>(root.size()); ++node) groups[find(node)].push_back(node);
  std::vector<std::vector<int>> tied;
  for (auto& [first, group] : groups)
    if (group.size() > 1) tied.push_back(std::move(group));
  return tied;
}

template std::vector<SideNode<2>> side_nodes(const StagePlan<2>&, const std::string&, const std::string&, const Origin&,
                                             bool);
template std::vector<SideNode<3>> side_nodes(const StagePlan<3>&, const std::string&, const std::string&, const Origin&,
                                             bool);

}  // namespace wetfront::mpm
