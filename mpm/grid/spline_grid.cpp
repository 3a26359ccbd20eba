#include "mpm/grid/spline_grid.h"

#include "mpm/problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace wetfront::mpm {

namespace {

using Axis = std::array<std::array<double, 3>, 3>;
constexpr Axis inner{{{0.5, -1, 0.5}, {0.5, 1, -1}, {0, 0, 0.5}}};
constexpr Axis first{{{1, -2, 1}, {0, 2, -1.5}, {0, 0, 0.5}}};
constexpr Axis last{{{0.5, -1, 0.5}, {0.5, 1, -1.5}, {0, 0, 1}}};
constexpr Axis only{{{1, -2, 1}, {0, 2, -2}, {0, 0, 1}}};

constexpr double integral(const std::array<double, 3>& c) {
  return c[0] + c[1] / 2 + c[2] / 3;
}

[[noreturn]] void refuse_mesh() {
  throw CannotPlan(
      "the skeleton is to move by quadratic splines, but the mesh is not a box cut evenly along the axes "
      "(the splines are products of functions of one coordinate each). Use such a mesh, or linear shape functions");
}

}  // namespace

template <int dim>
SplineGrid<dim>::SplineGrid(const meshes::Mesh& mesh) {
  constexpr int corners = cell_nodes<dim>;
  Vector<dim> end;
  origin_.fill(std::numeric_limits<double>::infinity());
  end.fill(-std::numeric_limits<double>::infinity());
  for (const auto& x : mesh.nodes)
    for (int a = 0; a < dim; ++a) origin_[a] = std::min(origin_[a], x[a]), end[a] = std::max(end[a], x[a]);
  const auto node = [&](std::size_t cell, int i) {
    return static_cast<std::size_t>(mesh.cells[cell * corners + static_cast<std::size_t>(i)]);
  };
  std::size_t product = 1;
  for (int a = 0; a < dim; ++a) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (int i = 0; i < corners; ++i) {
      low = std::min(low, mesh.nodes[node(0, i)][a]);
      high = std::max(high, mesh.nodes[node(0, i)][a]);
    }
    cells_[a] = static_cast<int>(std::lround((end[a] - origin_[a]) / (high - low)));
    spacing_[a] = (end[a] - origin_[a]) / cells_[a];
    product *= static_cast<std::size_t>(cells_[a]);
  }
  if (product != mesh.cell_count()) refuse_mesh();
  for (std::size_t i = 0; i < mesh.node_count(); ++i) mesh_node_at_.push_back(lattice(mesh, i));
  for (std::size_t cell = 0; cell < mesh.cell_count(); ++cell) {
    Lattice low = mesh_node_at_[node(cell, 0)];
    for (int i = 0; i < corners; ++i)
      for (int a = 0; a < dim; ++a) low[a] = std::min(low[a], mesh_node_at_[node(cell, i)][a]);
    for (int i = 0; i < corners; ++i)
      for (int a = 0; a < dim; ++a)
        if (mesh_node_at_[node(cell, i)][a] - low[a] > 1) refuse_mesh();
    cell_at_.push_back(low);
  }
}

template <int dim>
typename SplineGrid<dim>::Lattice SplineGrid<dim>::lattice(const meshes::Mesh& mesh, std::size_t mesh_node) const {
  Lattice at;
  for (int a = 0; a < dim; ++a) {
    const double place = (mesh.nodes[mesh_node][a] - origin_[a]) / spacing_[a];
    at[a] = static_cast<int>(std::lround(place));
    if (std::abs(place - at[a]) > 1e-6) refuse_mesh();  // mesh files hold six digits or more
  }
  return at;
}

template <int dim>
std::size_t SplineGrid<dim>::node_count() const {
  std::size_t count = 1;
  for (int n : cells_) count *= static_cast<std::size_t>(n + 2);
  return count;
}

template <int dim>
int SplineGrid<dim>::index(const Lattice& at) const {
  int index = at[dim - 1];
  for (int a = dim - 2; a >= 0; --a) index = index * (cells_[a] + 2) + at[a];
  return index;
}

template <int dim>
Vector<dim> SplineGrid<dim>::corner(std::size_t cell) const {
  Vector<dim> x;
  for (int a = 0; a < dim; ++a) x[a] = origin_[a] + cell_at_[cell][a] * spacing_[a];
  return x;
}

template <int dim>
void SplineGrid<dim>::nodes_of(std::size_t cell, int* nodes_out) const {
  for (int i = 0; i < nodes; ++i) {
    Lattice at = cell_at_[cell];
    for (int a = 0, rest = i; a < dim; ++a, rest /= 3) at[a] += rest % 3;
    nodes_out[i] = index(at);
  }
}

template <int dim>
const typename SplineGrid<dim>::Axis& SplineGrid<dim>::axis(std::size_t cell, int a) const {
  const int at = cell_at_[cell][a], end = cells_[a] - 1;
  if (end == 0) return only;
  return at == 0 ? first : at == end ? last : inner;
}

template <int dim>
Vector<dim> SplineGrid<dim>::place(int node) const {
  Vector<dim> x;
  for (int a = 0; a < dim; ++a) {
    const int at = node % (cells_[a] + 2);
    node /= cells_[a] + 2;
    x[a] = origin_[a] + spacing_[a] * std::clamp(at - 0.5, 0.0, static_cast<double>(cells_[a]));
  }
  return x;
}

template <int dim>
std::vector<typename SplineGrid<dim>::SideNode> SplineGrid<dim>::side(const meshes::Mesh& mesh,
                                                                      const std::string& name) const {
  constexpr std::size_t corners = dim == 2 ? 2 : 4;
  std::map<std::array<int, 3>, double> areas;  // node, axis, end
  for (const auto& side : mesh.sides)
    for (std::size_t f = 0; side.name == name && f + corners <= side.faces.size(); f += corners) {
      Lattice low, high;
      low.fill(std::numeric_limits<int>::max());
      high.fill(-1);
      for (std::size_t i = 0; i < corners; ++i)
        for (int a = 0; a < dim; ++a) {
          const int at = mesh_node_at_[static_cast<std::size_t>(side.faces[f + i])][a];
          low[a] = std::min(low[a], at), high[a] = std::max(high[a], at);
        }
      int normal = 0;
      while (normal < dim - 1 && low[normal] != high[normal]) ++normal;
      const bool upper = low[normal] == cells_[normal];
      if (!upper && low[normal] != 0) refuse_mesh();  // a side inside the box
      for (int i = 0; i < nodes / 3; ++i) {
        Lattice at = low;
        double area = 1;
        for (int a = 0, rest = i; a < dim; ++a) {
          if (a == normal) {
            at[a] = upper ? cells_[a] + 1 : 0;
            continue;
          }
          const Axis& kind = cells_[a] == 1 ? only : low[a] == 0 ? first : low[a] == cells_[a] - 1 ? last : inner;
          area *= spacing_[a] * integral(kind[static_cast<std::size_t>(rest % 3)]);
          at[a] += rest % 3;
          rest /= 3;
        }
        areas[{index(at), normal, upper ? 1 : 0}] += area;
      }
    }
  std::vector<SideNode> found;
  for (const auto& [where, area] : areas) found.push_back({where[0], area, where[1], where[2] == 1});
  return found;
}

template <int dim>
double SplineGrid<dim>::at_mesh_node(std::size_t mesh_node, const double* values) const {
  // At a knot inside two functions are one half each, at the border one is one.
  double sum = 0;
  for (int i = 0; i < cell_nodes<dim>; ++i) {
    Lattice at = mesh_node_at_[mesh_node];
    double weight = 1;
    for (int a = 0; a < dim; ++a) {
      const int shift = (i >> a) & 1, knot = at[a];
      const bool border = knot == 0 || knot == cells_[a];
      weight *= border ? (shift == (knot == 0 ? 0 : 1) ? 1.0 : 0.0) : 0.5;
      at[a] += shift;
    }
    if (weight > 0) sum += weight * values[index(at)];
  }
  return sum;
}

template class SplineGrid<2>;
template class SplineGrid<3>;

}  // namespace wetfront::mpm
