#include "mpm/two_velocity/cell_geometry.h"

namespace wetfront::mpm {

template <int dim>
std::vector<CellGeometry<dim>> cell_geometry(const Grid<dim>& grid) {
  std::vector<CellGeometry<dim>> cells;
  for (std::size_t c = 0; c < grid.cell_count(); ++c) {
    const double altitude = grid.smallest_altitude(c);
    cells.push_back({cell_integrals(grid, c), 4 / (altitude * altitude)});
  }
  return cells;
}

template std::vector<CellGeometry<2>> cell_geometry(const Grid<2>&);
template std::vector<CellGeometry<3>> cell_geometry(const Grid<3>&);

}  // namespace wetfront::mpm
