#include "mpm/boundary/boundary_side.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace wetfront::mpm {

std::string side_names(const meshes::Mesh& mesh) {
  std::string text;
  for (const auto& side : mesh.sides) {
    if (!text.empty()) text += ", ";
    text.append("'").append(side.name).append("'");
  }
  return text.empty() ? "none" : text;
}

namespace {

/// Integrals of N_i n over one face, oriented by the order of its nodes.
template <int dim>
std::array<Vector<dim>, cell_nodes<dim> / 2> face_integrals(const Grid<dim>& grid, const int* face) {
  std::array<Vector<dim>, cell_nodes<dim> / 2> out{};
  if constexpr (dim == 2) {
    const auto &a = grid.node(face[0]), &b = grid.node(face[1]);
    out[0] = out[1] = {0.5 * (b[1] - a[1]), -0.5 * (b[0] - a[0])};
  } else {
    const double gauss = 1 / std::sqrt(3.0);
    for (double u : {-gauss, gauss})
      for (double v : {-gauss, gauss}) {
        Stencil<2> s;
        reference_stencil<2>({u, v}, s);
        Vector<3> du{}, dv{};
        for (int i = 0; i < 4; ++i)
          for (int a = 0; a < 3; ++a) {
            du[a] += s.gradient[i][0] * grid.node(face[i])[a];
            dv[a] += s.gradient[i][1] * grid.node(face[i])[a];
          }
        for (int i = 0; i < 4; ++i)
          for (int a = 0; a < 3; ++a)
            out[i][a] += s.value[i] * (du[(a + 1) % 3] * dv[(a + 2) % 3] - du[(a + 2) % 3] * dv[(a + 1) % 3]);
      }
  }
  return out;
}

template <int dim>
int owner_of(const Grid<dim>& grid, const int* face, const std::vector<std::vector<std::size_t>>& cells_at) {
  constexpr int face_nodes = cell_nodes<dim> / 2;
  for (std::size_t cell : cells_at[static_cast<std::size_t>(face[0])]) {
    const int* nodes = grid.cell_nodes_of(cell);
    const auto has = [nodes](int node) {
      return std::find(nodes, nodes + cell_nodes<dim>, node) != nodes + cell_nodes<dim>;
    };
    if (std::all_of(face, face + face_nodes, has)) return static_cast<int>(cell);
  }
  return -1;
}

/// True when the face's integrals point into the cell.
template <int dim>
bool points_inwards(const Grid<dim>& grid, std::size_t cell, const int* face,
                    const std::array<Vector<dim>, cell_nodes<dim> / 2>& integrals) {
  const Vector<dim> centre = grid.place(cell, {});
  double towards_centre = 0;
  for (int a = 0; a < dim; ++a) {
    double normal = 0, middle = 0;
    for (int i = 0; i < cell_nodes<dim> / 2; ++i) {
      normal += integrals[static_cast<std::size_t>(i)][a];
      middle += grid.node(face[i])[a] / (cell_nodes<dim> / 2);
    }
    towards_centre += normal * (centre[a] - middle);
  }
  return towards_centre > 0;
}

}  // namespace

template <int dim>
BoundarySide<dim> boundary_side(const StagePlan<dim>& plan, const std::string& name, const std::string& who,
                                const Origin& origin) {
  const meshes::Mesh& mesh = plan.problem.mesh;
  const Grid<dim>& grid = plan.fields.grid;
  const auto side = std::find_if(mesh.sides.begin(), mesh.sides.end(), [&](const auto& s) { return s.name == name; });
  if (side == mesh.sides.end())
    throw CannotPlan(origin + ": " + who + " is asked for on side '" + name +
                     "', which the mesh does not have. Its sides are " + side_names(mesh));
  std::vector<std::vector<std::size_t>> cells_at(grid.node_count());
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell)
    for (int i = 0; i < cell_nodes<dim>; ++i)
      cells_at[static_cast<std::size_t>(grid.cell_nodes_of(cell)[i])].push_back(cell);
  constexpr std::size_t face_nodes = cell_nodes<dim> / 2;
  std::map<int, typename BoundarySide<dim>::Node> found;
  for (std::size_t f = 0; f + face_nodes <= side->faces.size(); f += face_nodes) {
    const int* face = &side->faces[f];
    const int owner = owner_of(grid, face, cells_at);
    if (owner < 0 || !plan.fields.points.occupied(static_cast<std::size_t>(owner))) continue;
    const auto cell = static_cast<std::size_t>(owner);
    const auto integrals = face_integrals<dim>(grid, face);
    const double sign = points_inwards<dim>(grid, cell, face, integrals) ? -1 : 1;
    for (std::size_t i = 0; i < face_nodes; ++i) {
      auto [entry, fresh] = found.try_emplace(face[i]);
      entry->second.index = face[i];
      entry->second.region = fresh ? grid.region(cell) : std::min(entry->second.region, grid.region(cell));
      for (int a = 0; a < dim; ++a) entry->second.area[a] += sign * integrals[i][a];
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
