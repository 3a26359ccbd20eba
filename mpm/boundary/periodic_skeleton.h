#pragma once

#include "mpm/boundary/skeleton_nodes.h"

namespace wetfront::mpm {

/// Tied nodes move as one: shares of the summed force by mass, so that each has the acceleration of all.
template <int dim>
class PeriodicCondition : public NodalCondition<dim> {
 public:
  PeriodicCondition(StagePlan<dim>& plan, const std::vector<PeriodicSkeleton>& sides);
  /// Here, not in add_force: all forces are to be there (water's come later), and damping sees the sum, not its parts.
  void see_force() override;
  void limit_acceleration() override;
  void limit_velocity() override;

 private:
  double mass_of(const std::vector<int>& group) const;
  void share(Column& column) const;  ///< the mean by mass

  SkeletonNodes<dim> nodes_;
  std::vector<std::vector<int>> groups_;
};

}  // namespace wetfront::mpm
