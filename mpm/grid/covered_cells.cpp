#include "mpm/grid/covered_cells.h"

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {

template <int dim>
CoveredCells<dim>::CoveredCells(const Grid<dim>& grid, const std::vector<int>& open)
    : grid_(grid),
      volume_(grid.cell_count()),
      covered_(grid.cell_count()),
      cells_around_(grid.node_count()),
      empty_around_(grid.node_count()),
      blocks_in_(grid.cell_count()) {
  const double place = 1 / std::sqrt(3.0);  // two Gauss points along an axis integrate the volume of any cell
  Stencil<dim> at;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    for (int k = 0; k < cell_nodes<dim>; ++k) {
      Vector<dim> xi;
      for (int a = 0; a < dim; ++a) xi[a] = (k >> a) % 2 == 0 ? -place : place;
      volume_[cell] += grid.stencil(cell, xi, at);
    }
    for (int i = 0; i < cell_nodes<dim>; ++i) ++cells_around_[static_cast<std::size_t>(grid.cell_nodes_of(cell)[i])];
  }
  for (const int node : open) ++cells_around_[static_cast<std::size_t>(node)];
}

template <int dim>
void CoveredCells<dim>::update(const MaterialPoints<dim>& points) {
  std::fill(blocks_in_.begin(), blocks_in_.end(), 0);
  empty_around_ = cells_around_;
  for (const Block& block : points.blocks())
    if (blocks_in_[block.cell]++ == 0)
      for (int i = 0; i < cell_nodes<dim>; ++i) --empty_around_[static_cast<std::size_t>(block.nodes[i])];
  std::fill(covered_.begin(), covered_.end(), 0.0);
  for (const Block& block : points.blocks()) {
    bool inside = blocks_in_[block.cell] == 1;
    for (int i = 0; i < cell_nodes<dim>; ++i) inside &= empty_around_[static_cast<std::size_t>(block.nodes[i])] == 0;
    if (inside) covered_[block.cell] = volume_[block.cell];
  }
}

template class CoveredCells<2>;
template class CoveredCells<3>;

}  // namespace wetfront::mpm
