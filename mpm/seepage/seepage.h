#pragma once

#include "mpm/coupling/skeleton_of_flow.h"
#include "mpm/seepage/nodal_water.h"
#include "mpm/seepage/seepage_step.h"
#include "mpm/seepage/soil_content.h"

namespace wetfront::mpm {

/// Pore liquid in a rigid skeleton: the mixed form of Richards' equation, implicit, on the grid.
///
///   sum_p V_p N_i n d(S(p_i) c(p_i))/dt = sum_p V_p grad N_i . q_p + boundary,
///   q_p = -(k k_rel/mu) T (grad p - rho g);   S c: SoilContent, k_rel: CellPermeability; all laws are those of the
///   point's own soil, whatever cell it is in.
///
/// The scheme semi-implicit keeps the liquid's inertia in q_p (LiquidInertia), its flux lives on the points.
/// p stays on the nodes between steps; points carry interpolated values for figures and for the next stage.
/// Adds the terms "storage" and "Darcy flux" to the nodal balance and solves it (SeepageStep).
template <int dim>
class Seepage : public Effect<dim> {
 public:
  /// `skeleton`: the split with a skeleton that deforms; null: rigid.
  Seepage(Origin origin, LiquidScheme scheme, std::shared_ptr<NodalWater<dim>> water,
          std::unique_ptr<SkeletonOfFlow<dim>> skeleton = nullptr)
      : Effect<dim>(
            scheme == LiquidScheme::seepage ? "seepage" : "semi-implicit liquid", std::move(origin),
            scheme == LiquidScheme::seepage
                ? "Lee 2021 Eqs 1 and 4 without inertia, Eq. 4 in flux form; Eqs 5 to 8; mpm/README.md section 3"
            : skeleton == nullptr
                ? "Lee 2021 Eqs 1 and 4 in flux form, v_s = 0; Eqs 5 to 8; mpm/README.md section 3"
                : "Lee 2021 Eqs 1, 2 and 4 in flux form; Eqs 5 to 8; mpm/coupling/README.md section 8b"),
        water_(std::move(water)),
        skeleton_(std::move(skeleton)) {}
  void join(StagePlan<dim>& plan) override;

 private:
  struct SoilLaws {
    SoilContent content;
    TabulatedPermeability permeability;
  };
  void provide_columns(StagePlan<dim>& plan);
  void add_storage(StagePlan<dim>& plan);
  void add_flux(StagePlan<dim>& plan);
  void add_point_update(StagePlan<dim>& plan);
  void add_ledger(StagePlan<dim>& plan);
  void add_output(StagePlan<dim>& plan);
  void prepare(StagePlan<dim>& plan);
  void build_matrix(StagePlan<dim>& plan);
  void follow_points(StagePlan<dim>& plan, bool cells_changed);
  void add_moving_points(StagePlan<dim>& plan);
  void measure_cells(const StagePlan<dim>& plan);

  std::shared_ptr<NodalWater<dim>> water_;
  SeepageColumns columns_;
  std::unique_ptr<SkeletonOfFlow<dim>> skeleton_;
  std::vector<SoilLaws> soils_;  ///< of every soil
  std::vector<SoilContent> contents_;
  std::vector<int> slots_;                     ///< matrix entries of every cell, cell_nodes^2 each
  std::vector<std::vector<double>> mobility_;  ///< k/mu of every soil, in every cell [m2/(Pa s)]
  std::vector<double> reach_;                  ///< half the box of every point, in local coordinates
  std::unique_ptr<SeepageStep<dim>> step_;
};

}  // namespace wetfront::mpm
