#include "mpm/coupling/water_pull.h"

namespace wetfront::mpm {

template <int dim>
void WaterPull<dim>::add_force() {
  constexpr int n = cell_nodes<dim>;
  const auto& grid = plan_.fields.grid;
  const auto& points = plan_.fields.points;
  const bool averaged = plan_.problem.skeleton.locking == LockingRemedy::b_bar;
  Vector<dim> weight = plan_.problem.gravity;
  for (double& component : weight) component *= plan_.problem.water->density;
  Stencil<dim> s;
  for (const Block& block : points.blocks()) {
    std::array<Vector<dim>, n> force{}, mean{};
    double whole = 0, push = 0;
    for (std::size_t p = block.first; p < block.first + block.count; ++p) {
      grid.stencil(block.cell, grid.local(block.cell, points.position(p)), s);
      const double v = volume_[0][p], pushed = averaged ? 0 : v * pore_stress_[0][p];
      whole += v;
      push += v * pore_stress_[0][p];
      for (int i = 0; i < n; ++i)
        for (int a = 0; a < dim; ++a) {
          force[i][a] += pushed * s.gradient[i][a] + s.value[i] * water_[0][p] * weight[a];
          mean[i][a] += v * s.gradient[i][a];
        }
    }
    const double pressure = averaged ? push / whole : 0;
    for (int i = 0; i < n; ++i)
      for (int a = 0; a < dim; ++a) force_[a][block.nodes[i]] += force[i][a] + pressure * mean[i][a];
  }
}

template class WaterPull<2>;
template class WaterPull<3>;

}  // namespace wetfront::mpm
