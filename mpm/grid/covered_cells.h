#pragma once

#include "mpm/grid/material_points.h"

#include <vector>

namespace wetfront::mpm {

/// Cells inside a body: every cell of the mesh that touches them by a node is occupied too, so that the body fills them
/// wherever its points happen to be. Cells at a free surface, at an open side of the mesh, and cells with points of two
/// soils are none.
template <int dim>
class CoveredCells {
 public:
  /// `open` are nodes of the mesh on sides from which a body may draw back.
  CoveredCells(const Grid<dim>& grid, const std::vector<int>& open);

  void update(const MaterialPoints<dim>& points);
  /// Per cell: its own volume where it is covered [m^dim], else 0.
  const double* volumes() const { return covered_.data(); }

 private:
  std::vector<double> volume_, covered_;
  std::vector<int> cells_around_, empty_around_;  ///< per node; an open node has one empty cell for ever
  std::vector<char> blocks_in_;                   ///< per cell
};

}  // namespace wetfront::mpm
