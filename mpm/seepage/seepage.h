#pragma once

#include "mpm/seepage/nodal_water.h"
#include "mpm/seepage/seepage_step.h"

namespace wetfront::mpm {

/// Pore liquid without inertia in a rigid skeleton: the mixed form of Richards' equation, implicit, on the grid.
///
///   sum_p V_p N_i n d(S(p_i) c(p_i))/dt = - sum_p V_p grad N_i . q_p + boundary,
///   q_p = -(k k_rel(p_p)/mu) (grad p - rho g),   c = 1 + p/K_l for p > 0, 1 otherwise.
///
/// p stays on the nodes between steps; points carry interpolated values for figures and for the next stage.
/// Adds the terms "storage" and "Darcy flux" to the nodal balance and solves it (SeepageStep).
template <int dim>
class Seepage : public Effect<dim> {
 public:
  Seepage(Origin origin, std::shared_ptr<NodalWater<dim>> water)
      : Effect<dim>("seepage", std::move(origin),
                    "Lee 2021 Eqs 1 and 4 without inertia, Eq. 4 in flux form; Eqs 5 to 8; mpm/README.md section 3"),
        water_(std::move(water)) {}
  void join(StagePlan<dim>& plan) override;

 private:
  void provide_columns(StagePlan<dim>& plan);
  void add_terms(StagePlan<dim>& plan);
  void add_point_update(StagePlan<dim>& plan);
  void add_ledger(StagePlan<dim>& plan);
  void add_output(StagePlan<dim>& plan);
  void prepare(StagePlan<dim>& plan);

  std::shared_ptr<NodalWater<dim>> water_;
  SeepageColumns columns_;
  std::vector<int> slots_;  ///< matrix entries of every cell, cell_nodes^2 each
  std::unique_ptr<SeepageStep<dim>> step_;
};

}  // namespace wetfront::mpm
