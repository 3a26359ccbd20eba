#pragma once

#include "mpm/skeleton/skeleton_cycle.h"

namespace wetfront::mpm {

/// What the pore water does to the skeleton, per cycle at the points' present places:
///
///   f_i += sum_p V_p (chi p)_p grad N_i + rho_l g sum_p W_p N_i,
///
/// the first with the mean gradient of the cell under LockingRemedy::b_bar (the adjoint of the volumetric strain),
/// which is that of all points in it, whatever their soil. Points carry "pore stress" chi p [Pa] and their "water" W
/// [m^dim].
template <int dim>
class WaterPull : public NodalCondition<dim> {
 public:
  explicit WaterPull(StagePlan<dim>& plan)
      : plan_(plan),
        force_(plan.require_on_nodes("force")),
        volume_(plan.require_on_points("volume")),
        pore_stress_(plan.require_on_points("pore stress")),
        water_(plan.require_on_points("water")),
        position_(plan.require_on_points("position")) {}
  void add_force() override;

 private:
  /// Sums over one cell's points at its nodes.
  struct CellPull {
    std::array<Vector<dim>, cell_nodes<dim>> push{};  ///< of push_ grad N_i
    std::array<double, cell_nodes<dim>> water{};      ///< of W N_i [m^dim]
  };
  void add_affine(const Block& block, CellPull& pull) const;
  void add_any(const Block& block, CellPull& pull) const;

  StagePlan<dim>& plan_;
  Column& force_;
  const Column &volume_, &pore_stress_, &water_, &position_;
  std::vector<double> push_;  ///< of the points of the block at hand
};

}  // namespace wetfront::mpm
