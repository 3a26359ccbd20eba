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
  for (const auto& [face, place] : outer_faces(plan)) {
    if (rained.contains(face)) continue;
    if (surface != nullptr && !surface->wets({face.begin(), face.end()})) continue;
    const Vector<dim> normal = share_of_face(grid, place);
    for (int node : face) shares_.emplace_back(node, normal);
  }
  gather(grid.node_count());
}

template <int dim>
ImpermeableWalls<dim>::ImpermeableWalls(const Grid<dim>& grid, const Body<dim>& body) {
  find(grid, body);
}

template <int dim>
void ImpermeableWalls<dim>::find(const Grid<dim>& grid, const Body<dim>& body) {
  shares_.clear();
  for (const auto& outer : body.outer()) {
    if (!outer.rains.empty()) continue;
    const Vector<dim> normal = share_of_face(grid, {outer.cell, outer.face});
    for (int local : local_face<dim>(outer.face)) shares_.emplace_back(grid.cell_nodes_of(outer.cell)[local], normal);
  }
  gather(grid.node_count());
}

/// Puts the shares of each node together, in their order, and makes of them what it forbids.
template <int dim>
void ImpermeableWalls<dim>::gather(std::size_t nodes) {
  for (const Node& walls : walls_) walls_of_[walls.index] = -1;
  walls_.clear();
  ends_.clear();
  walls_of_.resize(nodes, -1);
  for (const Share& share : shares_) {
    int& place = walls_of_[static_cast<std::size_t>(share.first)];
    if (place < 0) {
      place = static_cast<int>(walls_.size());
      walls_.push_back({static_cast<std::size_t>(share.first), 0, {}});
      ends_.push_back(0);
    }
    ++ends_[static_cast<std::size_t>(place)];
  }
  std::size_t end = 0;
  for (std::size_t k = 0; k < walls_.size(); ++k) end += std::exchange(ends_[k], end);
  normals_.resize(end);
  for (const Share& share : shares_)
    normals_[ends_[static_cast<std::size_t>(walls_of_[static_cast<std::size_t>(share.first)])]++] = share.second;
  for (std::size_t k = 0, first = 0; k < walls_.size(); first = ends_[k++])
    forbid(std::span(normals_).subspan(first, ends_[k] - first), walls_[k]);
}

/// Groups shares by direction and makes the groups' sums orthonormal.
template <int dim>
void ImpermeableWalls<dim>::forbid(std::span<const Vector<dim>> normals, Node& walls) {
  groups_.clear();
  for (const Vector<dim>& normal : normals) {
    const auto near = std::find_if(groups_.begin(), groups_.end(), [&](const Vector<dim>& other) {
      return dot<dim>(normal, other) > std::sqrt(0.5 * dot<dim>(normal, normal) * dot<dim>(other, other));
    });
    if (near == groups_.end())
      groups_.push_back(normal);
    else
      for (int a = 0; a < dim; ++a) (*near)[a] += normal[a];
  }
  for (Vector<dim> d : groups_) {
    const double size = std::sqrt(dot<dim>(d, d));
    for (int other = 0; other < walls.count; ++other) {
      const Vector<dim>& known = walls.direction[static_cast<std::size_t>(other)];
      const double along = dot<dim>(d, known);
      for (int a = 0; a < dim; ++a) d[a] -= along * known[a];
    }
    const double rest = std::sqrt(dot<dim>(d, d));
    if (rest < 1e-6 * size || walls.count == dim) continue;  // already forbidden
    for (double& component : d) component /= rest;
    walls.direction[static_cast<std::size_t>(walls.count++)] = d;
  }
}

template class ImpermeableWalls<2>;
template class ImpermeableWalls<3>;

}  // namespace wetfront::mpm
