#include "meshes/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace wetfront::meshes {
namespace {

/// Corners of the faces of a cell, as positions in the cell's node list.
std::vector<std::vector<int>> faces_of_cell(int dim) {
  if (dim == 1) return {{0}, {1}};
  if (dim == 2) return {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  return {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
}

Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double triple(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Twice the signed area of the triangle a, b, c in the x-y plane.
double cross(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Smallest Jacobian-like measure at the corners: positive for a usable cell.
double smallest_corner_measure(const Mesh& mesh, std::span<const int> cell) {
  const auto node = [&](int i) -> const Point& { return mesh.nodes[cell[i]]; };
  if (mesh.dim == 1) return node(1)[0] - node(0)[0];
  double smallest = std::numeric_limits<double>::infinity();
  if (mesh.dim == 2) {
    for (int i = 0; i < 4; ++i) smallest = std::min(smallest, cross(node(i), node((i + 1) % 4), node((i + 3) % 4)));
    return smallest;
  }
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4, previous = (i + 3) % 4;
    smallest = std::min(
        smallest, triple(minus(node(next), node(i)), minus(node(previous), node(i)), minus(node(i + 4), node(i))));
    smallest = std::min(smallest, triple(minus(node(previous + 4), node(i + 4)), minus(node(next + 4), node(i + 4)),
                                         minus(node(i), node(i + 4))));
  }
  return smallest;
}

/// How often each face (sorted node indices) is used by a cell.
std::map<std::vector<int>, int> count_faces(const Mesh& mesh) {
  std::map<std::vector<int>, int> uses;
  const auto corners = faces_of_cell(mesh.dim);
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const auto cell = mesh.cell(c);
    for (const auto& face : corners) {
      std::vector<int> nodes;
      for (int i : face) nodes.push_back(cell[i]);
      std::sort(nodes.begin(), nodes.end());
      ++uses[nodes];
    }
  }
  return uses;
}

void require(bool condition, const std::string& message) {
  if (!condition) throw std::invalid_argument(message);
}

}  // namespace

std::span<const int> Mesh::cell(std::size_t index) const {
  const std::size_t count = nodes_per_cell(dim);
  return {cells.data() + index * count, count};
}

Point Mesh::cell_centre(std::size_t index) const {
  Point centre{};
  const auto corner = cell(index);
  for (int node : corner)
    for (int axis = 0; axis < 3; ++axis) centre[axis] += nodes[node][axis] / corner.size();
  return centre;
}

double Mesh::cell_measure(std::size_t index) const {
  const auto corner = cell(index);
  const auto node = [&](int i) -> const Point& { return nodes[corner[i]]; };
  if (dim == 1) return node(1)[0] - node(0)[0];
  if (dim == 2) return 0.5 * (cross(node(0), node(1), node(2)) + cross(node(0), node(2), node(3)));
  // Six tetrahedra around the diagonal 0-6.
  constexpr int fan[6][2] = {{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}};
  double volume = 0;
  for (const auto& [a, b] : fan)
    volume += triple(minus(node(a), node(0)), minus(node(b), node(0)), minus(node(6), node(0))) / 6;
  return volume;
}

const Side& Mesh::side(const std::string& name) const {
  std::string known;
  for (const Side& side : sides) {
    if (side.name == name) return side;
    known += (known.empty() ? "" : ", ") + side.name;
  }
  throw std::out_of_range("the mesh has no side '" + name + "' (it has: " + known + ")");
}

void validate(const Mesh& mesh) {
  require(mesh.dim >= 1 && mesh.dim <= 3, "a mesh has 1, 2 or 3 dimensions, not " + std::to_string(mesh.dim));
  require(mesh.cell_count() > 0, "the mesh has no cells");
  require(mesh.cells.size() == mesh.cell_count() * nodes_per_cell(mesh.dim),
          "the mesh lists " + std::to_string(mesh.cells.size()) + " cell corners for " +
              std::to_string(mesh.cell_count()) + " cells");
  const int node_count = static_cast<int>(mesh.node_count());
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const std::string which = "cell " + std::to_string(c);
    for (int node : mesh.cell(c))
      require(node >= 0 && node < node_count, which + " uses node " + std::to_string(node) + ", which does not exist");
    require(mesh.region[c] >= 0 && mesh.region[c] < static_cast<int>(mesh.region_names.size()),
            which + " belongs to a region without a name");
    require(smallest_corner_measure(mesh, mesh.cell(c)) > 0, which + " is inverted or has no volume");
  }
  const auto uses = count_faces(mesh);
  const std::size_t per_face = nodes_per_face(mesh.dim);
  for (const Side& side : mesh.sides) {
    for (std::size_t f = 0; f + per_face <= side.faces.size(); f += per_face) {
      std::vector<int> face(side.faces.begin() + f, side.faces.begin() + f + per_face);
      std::sort(face.begin(), face.end());
      const auto found = uses.find(face);
      const std::string which = "face " + std::to_string(f / per_face) + " of side '" + side.name + "'";
      require(found != uses.end(), which + " is not the face of a cell");
      require(found->second == 1, which + " lies inside the mesh (two cells share it)");
    }
  }
}

}  // namespace wetfront::meshes
