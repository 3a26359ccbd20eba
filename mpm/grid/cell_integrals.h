#pragma once

#include "mpm/grid/grid.h"

#include <cmath>

namespace wetfront::mpm {

/// Integrals over a cell of the grid.
template <int dim>
struct CellIntegrals {
  double volume = 0;                                 ///< m^dim
  std::array<double, cell_nodes<dim>> extent{};      ///< of N_i [m^dim]
  std::array<Vector<dim>, cell_nodes<dim>> faces{};  ///< of grad N_i [m^(dim-1)]
};

/// Two Gauss points per axis: N det and dN/dx det are integrated exactly on straight quadrilaterals.
template <int dim>
CellIntegrals<dim> cell_integrals(const Grid<dim>& grid, std::size_t cell) {
  const double place = 1 / std::sqrt(3.0);
  CellIntegrals<dim> sums;
  Stencil<dim> at;
  for (int corner = 0; corner < cell_nodes<dim>; ++corner) {
    Vector<dim> xi{};
    for (int a = 0; a < dim; ++a) xi[a] = place * node_sign(corner, a);
    const double weight = grid.stencil(cell, xi, at);
    sums.volume += weight;
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      sums.extent[i] += weight * at.value[i];
      for (int a = 0; a < dim; ++a) sums.faces[i][a] += weight * at.gradient[i][a];
    }
  }
  return sums;
}

/// Mean of grad N_i over the cell [1/m].
template <int dim>
std::array<Vector<dim>, cell_nodes<dim>> mean_gradients(const Grid<dim>& grid, std::size_t cell) {
  auto [volume, extent, mean] = cell_integrals(grid, cell);
  for (Vector<dim>& one : mean)
    for (double& component : one) component /= volume;
  return mean;
}

}  // namespace wetfront::mpm
