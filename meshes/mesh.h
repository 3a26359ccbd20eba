#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace wetfront::meshes {

/// A place in space [m]. Coordinates beyond the mesh's dimension are zero.
/// In one dimension the only coordinate, `[0]`, is the elevation (up); in two dimensions `[1]` is.
using Point = std::array<double, 3>;

/// A named part of the boundary, e.g. "top" or "base".
struct Side {
  std::string name;
  /// Node indices, `nodes_per_face(dim)` per face, in the order of the mesh file.
  std::vector<int> faces;
};

/// A conforming mesh of line segments (dim 1), quadrilaterals (2) or hexahedra (3).
///
/// It is all that the two solvers share: where the cells are, which soil region each belongs to and
/// what the sides are called. No formula of either solver lives here.
struct Mesh {
  int dim = 2;
  std::vector<Point> nodes;
  /// Node indices, `nodes_per_cell(dim)` per cell, counter-clockwise (gmsh's order).
  std::vector<int> cells;
  /// Region index of each cell, into `region_names`.
  std::vector<int> region;
  std::vector<std::string> region_names;
  std::vector<Side> sides;

  std::size_t cell_count() const { return region.size(); }
  std::size_t node_count() const { return nodes.size(); }
  std::span<const int> cell(std::size_t index) const;
  /// Arithmetic mean of the cell's nodes [m].
  Point cell_centre(std::size_t index) const;
  /// Length, area or volume of a cell [m, m2, m3].
  double cell_measure(std::size_t index) const;
  /// The side of that name; throws std::out_of_range naming the sides there are.
  const Side& side(const std::string& name) const;
};

constexpr int nodes_per_cell(int dim) {
  return 1 << dim;
}
constexpr int nodes_per_face(int dim) {
  return 1 << (dim - 1);
}

/// Index of the elevation coordinate: 0 in one dimension, 1 in two, 2 in three.
constexpr int up_axis(int dim) {
  return dim - 1;
}

/// Throws std::invalid_argument, saying which cell or side and why, when indices are out of range,
/// a cell is inverted or has no volume, or a side has faces that are not on the boundary of a cell.
void validate(const Mesh& mesh);

}  // namespace wetfront::meshes
