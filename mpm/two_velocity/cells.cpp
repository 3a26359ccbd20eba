#include "mpm/two_velocity/water.h"

#include <cmath>

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
      faces(grid.cell_count()),
      centre(grid.cell_count()) {
  // Two Gauss points per axis integrate dN/dx det exactly on straight quadrilaterals.
  const double place = 1 / std::sqrt(3.0);
  Stencil<dim> s;
  for (std::size_t c = 0; c < grid.cell_count(); ++c) {
    size.push_back(grid.smallest_altitude(c));
    for (int corner = 0; corner < cell_nodes<dim>; ++corner) {
      Vector<dim> xi{};
      for (int a = 0; a < dim; ++a) xi[a] = place * node_sign(corner, a);
      const double weight = grid.stencil(c, xi, s);
      for (int i = 0; i < cell_nodes<dim>; ++i)
        for (int a = 0; a < dim; ++a) faces[c][i][a] += weight * s.gradient[i][a];
    }
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
