#pragma once

#include "mpm/grid/migration.h"

namespace wetfront::mpm {

/// Deforming skeleton, explicit in time, MUSL (Lee 2021, steps I to IX without liquid): effective stress of linear
/// elasticity in small increments with Jaumann's rotation, optional local damping (Cundall), fixed sides.
///
/// Provides on points "mass", "velocity", "stress" and the stencils, on nodes "mass", "force", "velocity",
/// "acceleration" and "displacement". Step limit: h/(sqrt(dim) c), c^2 = E_oed/((1-n) rho_s).
template <int dim>
class ElasticSkeleton : public Effect<dim> {
 public:
  explicit ElasticSkeleton(Origin origin)
      : Effect<dim>("elastic skeleton", std::move(origin),
                    "Lee 2021 Eqs 2, 11 to 17 and 19, corrected (mpm/README.md section 6)") {}
  void join(StagePlan<dim>& plan) override;

 private:
  void provide_columns(StagePlan<dim>& plan);
  void add_gather(StagePlan<dim>& plan);
  void add_accelerate(StagePlan<dim>& plan);
  void add_point_velocity(StagePlan<dim>& plan);
  void add_stress(StagePlan<dim>& plan);
  void add_move(StagePlan<dim>& plan);
  void find_fixed(StagePlan<dim>& plan);
  void fix(Column& vector) const;

  struct Columns {
    Column *mass, *velocity, *stress, *shape, *gradient, *increment;  // points
    Column *position, *volume;
    Column *node_mass, *node_force, *node_velocity, *node_acceleration, *node_displacement;
  } c_{};
  std::array<std::vector<int>, 3> fixed_;  ///< nodes, per axis
  std::unique_ptr<Migration<dim>> migration_;
};

}  // namespace wetfront::mpm
