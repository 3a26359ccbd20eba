#pragma once

#include "meshes/mesh.h"
#include "mpm/grid/grid.h"

#include <vector>

namespace wetfront::mpm {

/// Nodes per face of a cell, and faces per cell.
template <int dim>
constexpr int face_nodes = cell_nodes<dim> / 2;
template <int dim>
constexpr int cell_faces = 2 * dim;

/// Local nodes of a face, in an order that makes its normal point out of the cell.
template <int dim>
std::array<int, face_nodes<dim>> local_face(int face);

/// The faces of a grid: who is on either side, and which side of the mesh they belong to.
template <int dim>
class Faces {
 public:
  Faces(const Grid<dim>& grid, const meshes::Mesh& mesh);

  /// The cell across a face, -1 at the border of the mesh; then `side` tells where (-1: on no named side).
  int neighbour(std::size_t cell, int face) const { return neighbour_[cell * cell_faces<dim> + index(face)]; }
  int side(std::size_t cell, int face) const { return side_[cell * cell_faces<dim> + index(face)]; }
  bool border_node(int node) const { return border_node_[static_cast<std::size_t>(node)] != 0; }
  /// Integrals of N_i n over a face, n pointing out of the cell, in the order of local_face [m^(dim-1)].
  static std::array<Vector<dim>, face_nodes<dim>> integrals(const Grid<dim>& grid, std::size_t cell, int face);

 private:
  static std::size_t index(int face) { return static_cast<std::size_t>(face); }
  std::vector<int> neighbour_, side_;
  std::vector<char> border_node_;
};

}  // namespace wetfront::mpm
