#include "mpm/coupling/water_pull.h"

#include "mpm/grid/cell_moments.h"

namespace wetfront::mpm {

template <int dim>
void WaterPull<dim>::add_force() {
  const auto& grid = plan_.fields.grid;
  Vector<dim> weight = plan_.problem.gravity;
  for (double& component : weight) component *= plan_.problem.water->density;
  for (const Block& block : plan_.fields.points.blocks()) {
    const CellPull pull = grid.affine(block.cell) ? in_affine(block) : in_any(block);
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a) force_[a][block.nodes[i]] += pull.push[i][a] + pull.water[i] * weight[a];
  }
}

template <int dim>
bool WaterPull<dim>::averaged() const {
  return plan_.problem.skeleton.locking == LockingRemedy::b_bar;
}

/// The gradients of an affine cell follow from those by local coordinates by one matrix for all points.
template <int dim>
typename WaterPull<dim>::CellPull WaterPull<dim>::in_affine(const Block& block) const {
  const auto& grid = plan_.fields.grid;
  CellMoments<dim> water, pushed;  // with the mean gradient: of V, scaled afterwards
  double whole = 0, push = 0;
  for (std::size_t p = block.first; p < block.first + block.count; ++p) {
    const Vector<dim> xi = grid.local(block.cell, plan_.fields.points.position(p));
    const double v = volume_[0][p], g = pore_stress_[0][p];
    whole += v;
    push += v * g;
    water.add(xi, water_[0][p]);
    pushed.add(xi, averaged() ? v : v * g);
  }
  const double scale = averaged() ? push / whole : 1;
  const auto& inverse = grid.map(block.cell).inverse;
  CellPull pull;
  for (int i = 0; i < cell_nodes<dim>; ++i) {
    pull.water[i] = water.value(i);
    const Vector<dim> slope = pushed.slope(i);
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) pull.push[i][a] += scale * inverse[b][a] * slope[b];
  }
  return pull;
}

template <int dim>
typename WaterPull<dim>::CellPull WaterPull<dim>::in_any(const Block& block) const {
  const auto& grid = plan_.fields.grid;
  CellPull pull;
  double whole = 0, push = 0;
  Stencil<dim> s;
  for (std::size_t p = block.first; p < block.first + block.count; ++p) {
    grid.stencil(block.cell, grid.local(block.cell, plan_.fields.points.position(p)), s);
    const double v = volume_[0][p], g = pore_stress_[0][p];
    whole += v;
    push += v * g;
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      pull.water[i] += s.value[i] * water_[0][p];
      for (int a = 0; a < dim; ++a) pull.push[i][a] += (averaged() ? v : v * g) * s.gradient[i][a];
    }
  }
  if (averaged())
    for (Vector<dim>& force : pull.push)
      for (double& component : force) component *= push / whole;
  return pull;
}

template class WaterPull<2>;
template class WaterPull<3>;

}  // namespace wetfront::mpm
