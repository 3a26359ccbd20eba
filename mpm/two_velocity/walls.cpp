#include "mpm/two_velocity/walls.h"

#include "mpm/boundary/faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace wetfront::mpm {

namespace {

template <int dim>
using Face = std::array<int, face_nodes<dim>>;  ///< sorted nodes

/// Where a face is found: the cell that it belongs to and its number there.
struct Place {
  std::size_t cell;
  int face;
};

/// Faces that belong to exactly one occupied cell.
template <int dim>
std::map<Face<dim>, Place> outer_faces(const StagePlan<dim>& plan) {
  std::map<Face<dim>, Place> places;
  for (const Block& block : plan.fields.points.blocks())
    for (int f = 0; f < cell_faces<dim>; ++f) {
      Face<dim> face = local_face<dim>(f);
      for (int& node : face) node = block.nodes[node];
      std::sort(face.begin(), face.end());
      const auto [place, fresh] = places.try_emplace(face, Place{block.cell, f});
      if (!fresh) places.erase(place);
    }
  return places;
}

template <int dim>
std::set<Face<dim>> rain_faces(const Problem<dim>& problem) {
  std::set<Face<dim>> faces;
  constexpr std::size_t n = face_nodes<dim>;
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

/// The area vector of a face, out of its cell, shared evenly by its nodes.
template <int dim>
Vector<dim> share_of_face(const Grid<dim>& grid, const Place& place) {
  Vector<dim> share{};
  for (const Vector<dim>& part : Faces<dim>::integrals(grid, place.cell, place.face))
    for (int a = 0; a < dim; ++a) share[a] += part[a] / face_nodes<dim>;
  return share;
}

}  // namespace

template <int dim>
ImpermeableWalls<dim>::ImpermeableWalls(const StagePlan<dim>& plan, const CutSurface<dim>* surface) {
  const Grid<dim>& grid = plan.fields.grid;
  const auto rained = rain_faces(plan.problem);
  std::vector<std::vector<Vector<dim>>> groups(grid.node_count());
  for (const auto& [face, place] : outer_faces(plan)) {
    if (rained.contains(face)) continue;
    if (surface != nullptr && !surface->wets({face.begin(), face.end()})) continue;
    const Vector<dim> normal = share_of_face(grid, place);
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
