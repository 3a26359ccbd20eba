#include "mpm/boundary/boundary_side.h"

#include "mpm/boundary/faces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace wetfront::mpm {

std::string side_names(const meshes::Mesh& mesh) {
  std::string text;
  for (const auto& side : mesh.sides) {
    if (!text.empty()) text += ", ";
    text.append("'").append(side.name).append("'");
  }
  return text.empty() ? "none" : text;
}

const meshes::Side& named_side(const meshes::Mesh& mesh, const std::string& name, const std::string& who,
                               const Origin& origin) {
  const auto side = std::find_if(mesh.sides.begin(), mesh.sides.end(), [&](const auto& s) { return s.name == name; });
  if (side == mesh.sides.end())
    throw CannotPlan(origin + ": " + who + " is asked for on side '" + name +
                     "', which the mesh does not have. Its sides are " + side_names(mesh));
  return *side;
}

namespace {

/// A cell that has a face, and which one of its faces that is.
struct Owner {
  std::size_t cell;
  int face;
};
template <int dim>
std::optional<Owner> owner_of(const Grid<dim>& grid, const int* face,
                              const std::vector<std::vector<std::size_t>>& cells_at) {
  for (std::size_t cell : cells_at[static_cast<std::size_t>(face[0])])
    for (int f = 0; f < cell_faces<dim>; ++f) {
      const auto local = local_face<dim>(f);
      if (std::all_of(local.begin(), local.end(), [&](int i) {
            return std::find(face, face + face_nodes<dim>, grid.cell_nodes_of(cell)[i]) != face + face_nodes<dim>;
          }))
        return Owner{cell, f};
    }
  return std::nullopt;
}

}  // namespace

template <int dim>
BoundarySide<dim> boundary_side(const StagePlan<dim>& plan, const std::string& name, const std::string& who,
                                const Origin& origin) {
  const meshes::Mesh& mesh = plan.problem.mesh;
  const Grid<dim>& grid = plan.fields.grid;
  const meshes::Side* side = &named_side(mesh, name, who, origin);
  std::vector<std::vector<std::size_t>> cells_at(grid.node_count());
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell)
    for (int i = 0; i < cell_nodes<dim>; ++i)
      cells_at[static_cast<std::size_t>(grid.cell_nodes_of(cell)[i])].push_back(cell);
  std::map<int, typename BoundarySide<dim>::Node> found;
  for (std::size_t f = 0; f + face_nodes<dim> <= side->faces.size(); f += face_nodes<dim>) {
    const auto owner = owner_of(grid, &side->faces[f], cells_at);
    if (!owner || !plan.fields.points.occupied(owner->cell)) continue;
    const auto local = local_face<dim>(owner->face);
    const auto integrals = Faces<dim>::integrals(grid, owner->cell, owner->face);
    for (std::size_t i = 0; i < local.size(); ++i) {
      const int node = grid.cell_nodes_of(owner->cell)[local[i]], region = grid.region(owner->cell);
      auto [entry, fresh] = found.try_emplace(node);
      entry->second.index = node;
      entry->second.region = fresh ? region : std::min(entry->second.region, region);
      for (int a = 0; a < dim; ++a) entry->second.area[a] += integrals[i][a];
    }
  }
  if (found.empty())
    throw CannotPlan(origin + ": " + who + " is asked for on side '" + name +
                     "', but no cell behind that side holds a material point, so it can never act. Name a side that "
                     "borders soil");
  BoundarySide<dim> result{name, {}};
  for (const auto& entry : found) result.nodes.push_back(entry.second);
  return result;
}

template <int dim>
Vector<dim> upward(const Problem<dim>& problem) {
  Vector<dim> up{};
  double size = 0;
  for (double g : problem.gravity) size += g * g;
  size = std::sqrt(size);
  up[dim - 1] = 1;
  if (size > 0)
    for (int a = 0; a < dim; ++a) up[a] = -problem.gravity[a] / size;
  return up;
}

template <int dim>
std::vector<double> open_areas(const BoundarySide<dim>& side, const Problem<dim>& problem, const RainSide& rain) {
  const Vector<dim> up = upward(problem);
  const bool rains =
      std::any_of(rain.rain.intensity.begin(), rain.rain.intensity.end(), [](double i) { return i > 0; });
  std::vector<double> areas;
  double total = 0, horizontal = 0, lowest = 0;
  for (const auto& node : side.nodes) {
    double area = 0, square = 0;
    for (int a = 0; a < dim; ++a) {
      area += node.area[a] * up[a];
      square += node.area[a] * node.area[a];
    }
    areas.push_back(rains ? area : std::sqrt(square));
    total += std::sqrt(square);
    horizontal += area;
    lowest = std::min(lowest, area);
  }
  // A millionth of the side's area: far above round-off, far below any slope that rain could be meant for.
  if (rains && (horizontal < 1e-6 * total || lowest < -1e-6 * total))
    throw CannotPlan(rain.origin + ": rainfall is asked for on side '" + side.name +
                     "', which is vertical or faces downwards (rain falls per horizontal area, so none would reach the "
                     "soil). Name a side that faces the sky");
  return areas;
}

template BoundarySide<2> boundary_side(const StagePlan<2>&, const std::string&, const std::string&, const Origin&);
template BoundarySide<3> boundary_side(const StagePlan<3>&, const std::string&, const std::string&, const Origin&);
template std::array<double, 2> upward<2>(const Problem<2>&);
template std::array<double, 3> upward<3>(const Problem<3>&);
template std::vector<double> open_areas(const BoundarySide<2>&, const Problem<2>&, const RainSide&);
template std::vector<double> open_areas(const BoundarySide<3>&, const Problem<3>&, const RainSide&);

}  // namespace wetfront::mpm
