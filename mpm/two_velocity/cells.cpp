#include "mpm/two_velocity/cell_geometry.h"
#include "mpm/two_velocity/water.h"

namespace wetfront::mpm {

template <int dim>
TwoVelocityCells<dim>::TwoVelocityCells(const Grid<dim>& grid)
    : volume(grid.cell_count()),
      pores(grid.cell_count()),
      water(grid.cell_count()),
      pressure(grid.cell_count()),
      mobility(grid.cell_count()),
      share(grid.cell_count()),
      gradient(grid.cell_count()),
      hanging(grid.cell_count()),
      centre(grid.cell_count()) {
  for (const CellGeometry<dim>& cell : cell_geometry(grid)) {
    stiffness.push_back(cell.stiffness);
    faces.push_back(cell.faces);
  }
}

template <int dim>
void TwoVelocityCells<dim>::sum(const Grid<dim>& grid, const PointColumns& points, const Block& block, double grains) {
  const std::size_t c = block.cell;
  volume[c] = 0;
  share[c] = {};
  gradient[c] = {};
  centre[c] = {};
  for (std::size_t q = block.first; q < block.first + block.count; ++q) {
    const double v = points.volume[0][q];
    volume[c] += v;
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      share[c][i] += v * points.shape[i][q];
      for (int a = 0; a < dim; ++a) gradient[c][i][a] += v * points.slope[i * dim + a][q];
    }
  }
  pores[c] = volume[c] - grains;
  for (int i = 0; i < cell_nodes<dim>; ++i)
    for (int a = 0; a < dim; ++a) centre[c][a] += share[c][i] / volume[c] * grid.node(block.nodes[i])[a];
  hanging[c] = {};
  for (std::size_t q = block.first; q < block.first + block.count; ++q) {
    double below = 0;  // rho_l g.(x_p - centre)
    for (int a = 0; a < dim; ++a) {
      double x = -centre[c][a];
      for (int i = 0; i < cell_nodes<dim>; ++i) x += points.shape[i][q] * grid.node(block.nodes[i])[a];
      below += points.weight[a] * x;
    }
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a) hanging[c][i][a] += points.volume[0][q] * points.slope[i * dim + a][q] * below;
  }
}

template struct TwoVelocityCells<2>;
template struct TwoVelocityCells<3>;

}  // namespace wetfront::mpm
