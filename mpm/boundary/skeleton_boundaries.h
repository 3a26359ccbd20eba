#pragma once

#include "mpm/skeleton/skeleton_cycle.h"

namespace wetfront::mpm {

/// What acts on the sides of a deforming skeleton: loads, given motions, absorbing sides, periodic sides, contact, in
/// that order (walls last: nothing moves a node into the base after it). Throws CannotPlan where one cannot act.
template <int dim>
class SkeletonBoundaries : public Effect<dim> {
 public:
  SkeletonBoundaries(const Problem<dim>& problem, std::shared_ptr<SkeletonCycle<dim>> cycle);
  void join(StagePlan<dim>& plan) override;

 private:
  std::shared_ptr<SkeletonCycle<dim>> cycle_;
};

}  // namespace wetfront::mpm
