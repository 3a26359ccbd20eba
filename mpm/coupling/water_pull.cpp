#include "mpm/coupling/water_pull.h"

#include "mpm/grid/cell_moments.h"
#include "mpm/grid/column_vector.h"
#include "mpm/grid/soils_of_cells.h"

namespace wetfront::mpm {

template <int dim>
void WaterPull<dim>::add_force() {
  const auto& grid = plan_.fields.grid;
  const bool averaged = plan_.problem.skeleton.locking == LockingRemedy::b_bar;
  Vector<dim> weight = plan_.problem.gravity;
  for (double& component : weight) component *= plan_.problem.water->density;
  each_cell(plan_.fields.points, [&](std::span<const Block* const> blocks) {
    // V chi p of each point by its own gradient, or the cell's mean of chi p by V and all its gradients.
    double whole = 0, push = 0;
    CellPull pull;
    for (const Block* block : blocks) {
      push_.clear();
      for (std::size_t p = block->first; p < block->first + block->count; ++p) {
        const double v = volume_[0][p], pushed = v * pore_stress_[0][p];
        whole += v;
        push += pushed;
        push_.push_back(averaged ? v : pushed);
      }
      grid.affine(block->cell) ? add_affine(*block, pull) : add_any(*block, pull);
    }
    const double scale = averaged ? push / whole : 1;
    const int* nodes = blocks.front()->nodes;
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a) force_[a][nodes[i]] += scale * pull.push[i][a] + pull.water[i] * weight[a];
  });
}

/// The gradients of an affine cell follow from those by local coordinates by one matrix for all points.
template <int dim>
void WaterPull<dim>::add_affine(const Block& block, CellPull& pull) const {
  const auto& map = plan_.fields.grid.map(block.cell);
  CellMoments<dim> water, pushed;
  for (std::size_t k = 0; k < block.count; ++k) {
    const Vector<dim> xi = map.local(at<dim>(position_, block.first + k));
    water.add(xi, water_[0][block.first + k]);
    pushed.add(xi, push_[k]);
  }
  for (int i = 0; i < cell_nodes<dim>; ++i) {
    pull.water[i] += water.value(i);
    const Vector<dim> slope = pushed.slope(i);
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) pull.push[i][a] += map.inverse[b][a] * slope[b];
  }
}

template <int dim>
void WaterPull<dim>::add_any(const Block& block, CellPull& pull) const {
  const auto& grid = plan_.fields.grid;
  Stencil<dim> s;
  for (std::size_t k = 0; k < block.count; ++k) {
    grid.stencil(block.cell, grid.local(block.cell, at<dim>(position_, block.first + k)), s);
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      pull.water[i] += s.value[i] * water_[0][block.first + k];
      for (int a = 0; a < dim; ++a) pull.push[i][a] += push_[k] * s.gradient[i][a];
    }
  }
}

template class WaterPull<2>;
template class WaterPull<3>;

}  // namespace wetfront::mpm
