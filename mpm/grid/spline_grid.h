#pragma once

#include "mpm/grid/grid.h"

#include <array>
#include <vector>

namespace wetfront::mpm {

/// Quadratic B-splines on a Cartesian grid of equal cells, with open knots (Steffen, Kirby & Berzins 2008): along an
/// axis with n cells n+2 functions, three of which live in any cell; the first and the last take their value on the
/// border, so that sides are held there as with linear functions. The functions stand at their Greville places.
template <int dim>
class SplineGrid {
 public:
  static constexpr int nodes = dim == 2 ? 9 : 27;
  /// Coefficients of 1, t, t2 of the three functions of a cell, t in [0, 1].
  using Axis = std::array<std::array<double, 3>, 3>;

  /// Throws CannotPlan when the cells are not those of a box cut evenly along the axes.
  explicit SplineGrid(const meshes::Mesh& mesh);

  std::size_t node_count() const;
  double spacing(int axis) const { return spacing_[axis]; }  ///< of cells [m]
  Vector<dim> corner(std::size_t cell) const;                ///< lowest [m]
  void nodes_of(std::size_t cell, int* nodes) const;
  const Axis& axis(std::size_t cell, int axis) const;
  /// Where a function stands: along an axis 0, h/2, 3h/2, ..., L - h/2, L [m].
  Vector<dim> place(int node) const;
  /// The functions that do not vanish on a side of the box, with the integral of each over the faces of the side
  /// [m^(dim-1)]; `faces` are those of the mesh with that name, `inside` says of a cell whether it counts.
  struct SideNode {
    int index;
    double area;
    int axis;    ///< the face's
    bool upper;  ///< it lies at the box's far end
  };
  std::vector<SideNode> side(const meshes::Mesh& mesh, const std::string& name) const;
  /// A nodal field at a node of the mesh.
  double at_mesh_node(std::size_t mesh_node, const double* values) const;

 private:
  using Lattice = std::array<int, dim>;
  int index(const Lattice& at) const;
  Lattice lattice(const meshes::Mesh& mesh, std::size_t mesh_node) const;

  Vector<dim> origin_{}, spacing_{};
  Lattice cells_{};
  std::vector<Lattice> cell_at_, mesh_node_at_;
};

}  // namespace wetfront::mpm
