#pragma once

#include "mpm/grid/cell_integrals.h"

#include <vector>

namespace wetfront::mpm {

/// Per cell what does not depend on the points.
template <int dim>
struct CellGeometry : CellIntegrals<dim> {
  double stiffness = 0;  ///< 4/h^2, h the smallest altitude [1/m2]
};

template <int dim>
std::vector<CellGeometry<dim>> cell_geometry(const Grid<dim>& grid);

}  // namespace wetfront::mpm
