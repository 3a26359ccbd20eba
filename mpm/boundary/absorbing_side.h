#pragma once

#include "mpm/boundary/skeleton_nodes.h"

namespace wetfront::mpm {

/// t = -rho c_p v_n n - rho c_s v_t, taken at the new velocity (no limit on the step), and the force that held the side
/// when the stage began: what carried the body goes on carrying it. In a quasi-static stage the side is held.
template <int dim>
class AbsorbingCondition : public NodalCondition<dim> {
 public:
  AbsorbingCondition(StagePlan<dim>& plan, SkeletonCycle<dim>& cycle, const std::vector<AbsorbingSide>& sides);
  void limit_acceleration() override;
  void limit_velocity() override;

 private:
  StagePlan<dim>& plan_;
  SkeletonCycle<dim>& cycle_;
  SkeletonNodes<dim> nodes_;
  Column &reaction_, &known_;
  std::vector<int> index_;
  std::vector<std::array<Vector<dim>, dim>> resistance_;  ///< [N s/m]
};

}  // namespace wetfront::mpm
