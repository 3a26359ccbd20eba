#pragma once

#include "mpm/plan/stage_plan.h"

namespace wetfront::mpm {

/// The point columns in which a skeleton effect offers the stencils of the points: "shape value" (component i: N_i)
/// and "shape gradient" (component i*dim+a: dN_i/dx_a).
template <int dim>
ColumnSpec shape_value_spec() {
  return {"shape value", "N", "-", cell_nodes<dim>, Lifetime::step};
}
template <int dim>
ColumnSpec shape_gradient_spec() {
  return {"shape gradient", "grad N", "1/m", dim * cell_nodes<dim>, Lifetime::step};
}

/// Fills both columns from the present positions of a block's points.
template <int dim>
void fill_stencils(const Grid<dim>& grid, const MaterialPoints<dim>& points, const Block& block, Column& value,
                   Column& gradient);

/// Points that never move: their stencils are computed once per stage.
template <int dim>
class RigidSkeleton : public Effect<dim> {
 public:
  explicit RigidSkeleton(Origin origin)
      : Effect<dim>("rigid skeleton", std::move(origin), "v_s = 0; Lee 2021 Eq. 9 (stencils)") {}
  void join(StagePlan<dim>& plan) override;
};

}  // namespace wetfront::mpm
