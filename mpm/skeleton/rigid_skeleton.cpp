#include "mpm/skeleton/rigid_skeleton.h"

namespace wetfront::mpm {

template <int dim>
void fill_stencils(const Grid<dim>& grid, const MaterialPoints<dim>& points, const Block& block, Column& value,
                   Column& gradient) {
  Stencil<dim> s;
  for (std::size_t p = block.first; p < block.first + block.count; ++p) {
    grid.stencil(block.cell, grid.local(block.cell, points.position(p)), s);
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      value[i][p] = s.value[i];
      for (int a = 0; a < dim; ++a) gradient[i * dim + a][p] = s.gradient[i][a];
    }
  }
}

template <int dim>
void RigidSkeleton<dim>::join(StagePlan<dim>& plan) {
  Column& value = plan.provide_on_points(shape_value_spec<dim>());
  Column& gradient = plan.provide_on_points(shape_gradient_spec<dim>());
  plan.at_ready([&fields = plan.fields, &value, &gradient] {
    for (const Block& block : fields.points.blocks())
      fill_stencils<dim>(fields.grid, fields.points, block, value, gradient);
  });
}

template void fill_stencils(const Grid<2>&, const MaterialPoints<2>&, const Block&, Column&, Column&);
template void fill_stencils(const Grid<3>&, const MaterialPoints<3>&, const Block&, Column&, Column&);
template class RigidSkeleton<2>;
template class RigidSkeleton<3>;

}  // namespace wetfront::mpm
