#pragma once

#include "mpm/grid/grid.h"

#include <vector>

namespace wetfront::mpm {

/// Per cell what does not depend on the points.
template <int dim>
struct CellGeometry {
  std::array<Vector<dim>, cell_nodes<dim>> faces{};  ///< integral of grad N_i [m^(dim-1)]
  std::array<double, cell_nodes<dim>> extent{};      ///< integral of N_i [m^dim]
  double volume = 0;                                 ///< m^dim
  double stiffness = 0;                              ///< 4/h^2, h the smallest altitude [1/m2]
};

template <int dim>
std::vector<CellGeometry<dim>> cell_geometry(const Grid<dim>& grid);

}  // namespace wetfront::mpm
