#include "mpm/two_velocity/walls.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace wetfront::mpm {

namespace {

template <int dim>
using Face = std::array<int, cell_nodes<dim> / 2>;  ///< sorted nodes

template <int dim>
double dot(const Vector<dim>& a, const Vector<dim>& b) {
  double sum = 0;
  for (int i = 0; i < dim; ++i) sum += a[i] * b[i];
  return sum;
}

/// The faces of a cell as local node indices: those on which one local coordinate is -1 or +1.
template <int dim>
std::vector<Face<dim>> faces_of_reference_cell() {
  std::vector<Face<dim>> faces;
  for (int axis = 0; axis < dim; ++axis)
    for (double sign : {-1.0, 1.0}) {
      Face<dim> face{};
      int found = 0;
      for (int i = 0; i < cell_nodes<dim>; ++i)
        if (node_sign(i, axis) == sign) face[static_cast<std::size_t>(found++)] = i;
      faces.push_back(face);
    }
  return faces;
}

/// Faces that belong to exactly one occupied cell, with that cell.
template <int dim>
std::map<Face<dim>, std::size_t> outer_faces(const StagePlan<dim>& plan) {
  std::map<Face<dim>, std::size_t> owner;
  const auto reference = faces_of_reference_cell<dim>();
  for (const Block& block : plan.fields.points.blocks())
    for (Face<dim> face : reference) {
      for (int& node : face) node = block.nodes[node];
      std::sort(face.begin(), face.end());
      const auto [place, fresh] = owner.try_emplace(face, block.cell);
      if (!fresh) owner.erase(place);
    }
  return owner;
}

template <int dim>
std::set<Face<dim>> rain_faces(const Problem<dim>& problem) {
  std::set<Face<dim>> faces;
  constexpr std::size_t n = cell_nodes<dim> / 2;
  for (const auto& boundary : problem.water_boundary)
    if (const auto* rain = std::get_if<RainSide>(&boundary))
      for (const auto& side : problem.mesh.sides)
        for (std::size_t f = 0; side.name == rain->side && f + n <= side.faces.size(); f += n) {
          Face<dim> face{};
          std::copy_n(side.faces.begin() + static_cast<std::ptrdiff_t>(f), n, face.begin());
          std::sort(face.begin(), face.end());
          faces.insert(face);
        }
  return faces;
}

/// Integral of N_i n over a face for its nodes taken together, shared evenly: the area vector of the face over its
/// number of nodes. (Exact for edges; for warped quadrilaterals the direction is what matters here.)
template <int dim>
Vector<dim> share_of_face(const Grid<dim>& grid, const Face<dim>& face, std::size_t cell) {
  Vector<dim> normal{}, middle{};
  for (int node : face)
    for (int a = 0; a < dim; ++a) middle[a] += grid.node(node)[a] / static_cast<double>(face.size());
  const auto edge = [&](int from, int to) {
    Vector<dim> e{};
    for (int a = 0; a < dim; ++a) e[a] = grid.node(face[to])[a] - grid.node(face[from])[a];
    return e;
  };
  if constexpr (dim == 2) {
    const Vector<2> e = edge(0, 1);
    normal = {e[1] / 2, -e[0] / 2};
  } else {
    // Sorted nodes are in no order around the face: the largest of the three triangles' normals at its first node.
    double largest = 0;
    for (const auto& [j, k] : {std::pair{1, 2}, std::pair{1, 3}, std::pair{2, 3}}) {
      const Vector<3> u = edge(0, j), v = edge(0, k);
      const Vector<3> n{(u[1] * v[2] - u[2] * v[1]) / 4, (u[2] * v[0] - u[0] * v[2]) / 4,
                        (u[0] * v[1] - u[1] * v[0]) / 4};
      if (dot<3>(n, n) > largest) normal = n, largest = dot<3>(n, n);
    }
  }
  const Vector<dim> centre = grid.place(cell, {});
  double outwards = 0;
  for (int a = 0; a < dim; ++a) outwards += normal[a] * (middle[a] - centre[a]);
  if (outwards < 0)
    for (double& component : normal) component = -component;
  return normal;
}

}  // namespace

template <int dim>
ImpermeableWalls<dim>::ImpermeableWalls(const StagePlan<dim>& plan, const CutSurface<dim>* surface) {
  const Grid<dim>& grid = plan.fields.grid;
  const auto rained = rain_faces(plan.problem);
  std::vector<std::vector<Vector<dim>>> groups(grid.node_count());
  for (const auto& [face, cell] : outer_faces(plan)) {
    if (rained.contains(face)) continue;
    if (surface != nullptr && !surface->wets({face.begin(), face.end()})) continue;
    const Vector<dim> normal = share_of_face(grid, face, cell);
    for (int node : face) {
      auto& at_node = groups[static_cast<std::size_t>(node)];
      const auto near = std::find_if(at_node.begin(), at_node.end(), [&](const Vector<dim>& other) {
        return dot<dim>(normal, other) > std::sqrt(0.5 * dot<dim>(normal, normal) * dot<dim>(other, other));
      });
      if (near == at_node.end())
        at_node.push_back(normal);
      else
        for (int a = 0; a < dim; ++a) (*near)[a] += normal[a];
    }
  }
  start_.assign(1, 0);
  for (auto& at_node : groups) {
    const std::size_t first = directions_.size();
    for (Vector<dim> d : at_node) {
      const double size = std::sqrt(dot<dim>(d, d));
      for (std::size_t k = first; k < directions_.size(); ++k) {
        const double along = dot<dim>(d, directions_[k]);
        for (int a = 0; a < dim; ++a) d[a] -= along * directions_[k][a];
      }
      const double rest = std::sqrt(dot<dim>(d, d));
      if (rest < 1e-6 * size) continue;  // already forbidden
      for (double& component : d) component /= rest;
      directions_.push_back(d);
    }
    start_.push_back(static_cast<int>(directions_.size()));
  }
}

template class ImpermeableWalls<2>;
template class ImpermeableWalls<3>;

}  // namespace wetfront::mpm
