#pragma once

#include "mpm/boundary/skeleton_nodes.h"

namespace wetfront::mpm {

/// v_i as given. In a quasi-static stage the side goes to where it is at the end of the step, a twentieth of the step's
/// way at most per cycle; `settled` says when it is there.
template <int dim>
class MovingCondition : public NodalCondition<dim> {
 public:
  MovingCondition(StagePlan<dim>& plan, SkeletonCycle<dim>& cycle, const MovingSide& spec);
  void limit_acceleration() override;
  void limit_velocity() override;
  bool settled() const override;

 private:
  double velocity_now(int axis, std::size_t node) const;
  double way(double time) const;  ///< int of the factor [s]

  StagePlan<dim>& plan_;
  SkeletonCycle<dim>& cycle_;
  SkeletonNodes<dim> nodes_;
  const Column& displacement_;
  MovingSide spec_;
  std::vector<int> index_;
};

}  // namespace wetfront::mpm
