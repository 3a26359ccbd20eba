#include "mpm/grid/covered_cells.h"

#include "mpm/grid/cell_integrals.h"

#include <algorithm>

namespace wetfront::mpm {

template <int dim>
CoveredCells<dim>::CoveredCells(const Grid<dim>& grid, const std::vector<int>& open)
    : volume_(grid.cell_count()),
      covered_(grid.cell_count()),
      cells_around_(grid.node_count()),
      empty_around_(grid.node_count()),
      blocks_in_(grid.cell_count()) {
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    volume_[cell] = cell_integrals(grid, cell).volume;
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
