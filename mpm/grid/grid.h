#pragma once

#include "meshes/mesh.h"
#include "mpm/grid/stencil.h"
#include "mpm/plan/column.h"

#include <vector>

namespace wetfront::mpm {

/// The background grid: cells and nodes of a conforming quadrilateral or hexahedral mesh, and the nodal columns.
template <int dim>
class Grid {
 public:
  explicit Grid(const meshes::Mesh& mesh);

  std::size_t node_count() const { return positions_.size(); }
  std::size_t cell_count() const { return regions_.size(); }
  const int* cell_nodes_of(std::size_t cell) const { return &nodes_[cell * cell_nodes<dim>]; }
  const Vector<dim>& node(int index) const { return positions_[static_cast<std::size_t>(index)]; }
  int region(std::size_t cell) const { return regions_[cell]; }
  /// Shortest distance between two nodes of the cell's opposite faces [m]: its smallest altitude.
  double smallest_altitude(std::size_t cell) const { return altitude_[cell]; }
  const std::vector<double>& smallest_altitudes() const { return altitude_; }

  /// Local coordinates of a place, in [-1, 1]^dim when it lies inside. One small matrix product in an affine cell
  /// (parallelogram), Newton's method in others.
  Vector<dim> local(std::size_t cell, const Vector<dim>& x) const;
  Vector<dim> place(std::size_t cell, const Vector<dim>& xi) const;
  /// Shape functions and gradients at local coordinates; returns det(dx/dxi) [m^dim].
  double stencil(std::size_t cell, const Vector<dim>& xi, Stencil<dim>& out) const;
  bool affine(std::size_t cell) const { return affine_[cell] != 0; }
  /// Outward unit normal of the face across an axis (the one at +1 when `upper`), at local coordinates on it.
  Vector<dim> face_normal(std::size_t cell, const Vector<dim>& xi, int axis, bool upper) const;

  /// The cell that holds x, searched from a nearby one through neighbours, -1 when x lies outside the grid.
  int find_cell(const Vector<dim>& x, int start) const;

  ColumnSet columns;

  /// xi = inverse (x - centre).
  struct AffineMap {
    Vector<dim> centre{};
    std::array<Vector<dim>, dim> inverse{};  ///< dxi/dx
    double determinant = 0;                  ///< of dx/dxi

    /// Local coordinates of a place.
    Vector<dim> local(const Vector<dim>& x) const {
      Vector<dim> xi{};
      for (int a = 0; a < dim; ++a)
        for (int b = 0; b < dim; ++b) xi[a] += inverse[a][b] * (x[b] - centre[b]);
      return xi;
    }
  };
  /// The map at the centre of a cell; all of it when the cell is affine.
  const AffineMap& map(std::size_t cell) const { return maps_[cell]; }

 private:
  AffineMap map_at(std::size_t cell, const Vector<dim>& xi) const;
  double measure_altitude(std::size_t cell) const;
  void find_neighbours();

  std::vector<Vector<dim>> positions_;
  std::vector<int> nodes_, regions_;
  std::vector<AffineMap> maps_;  ///< at the centre of each cell
  std::vector<char> affine_;
  std::vector<double> altitude_;
  std::vector<int> neighbour_start_, neighbours_;  ///< cells that share a node with a cell
};

}  // namespace wetfront::mpm
