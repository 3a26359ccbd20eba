#include "mpm/two_velocity/cell_geometry.h"

#include <cmath>

namespace wetfront::mpm {

/// Two Gauss points per axis integrate N det and dN/dx det exactly on straight quadrilaterals.
template <int dim>
std::vector<CellGeometry<dim>> cell_geometry(const Grid<dim>& grid) {
  const double place = 1 / std::sqrt(3.0);
  std::vector<CellGeometry<dim>> cells(grid.cell_count());
  Stencil<dim> s;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const double altitude = grid.smallest_altitude(c);
    cells[c].stiffness = 4 / (altitude * altitude);
    for (int corner = 0; corner < cell_nodes<dim>; ++corner) {
      Vector<dim> xi{};
      for (int a = 0; a < dim; ++a) xi[a] = place * node_sign(corner, a);
      const double weight = grid.stencil(c, xi, s);
      cells[c].volume += weight;
      for (int i = 0; i < cell_nodes<dim>; ++i) {
        cells[c].extent[i] += weight * s.value[i];
        for (int a = 0; a < dim; ++a) cells[c].faces[i][a] += weight * s.gradient[i][a];
      }
    }
  }
  return cells;
}

template std::vector<CellGeometry<2>> cell_geometry(const Grid<2>&);
template std::vector<CellGeometry<3>> cell_geometry(const Grid<3>&);

}  // namespace wetfront::mpm
