#pragma once

#include "mpm/boundary/time_record.h"
#include "mpm/skeleton/skeleton_cycle.h"

namespace wetfront::mpm {

/// The nodal columns of the skeleton that conditions read and change.
template <int dim>
struct SkeletonNodes {
  explicit SkeletonNodes(StagePlan<dim>& plan)
      : mass(plan.require_on_nodes("mass")),
        force(plan.require_on_nodes("force")),
        velocity(plan.require_on_nodes("velocity")),
        acceleration(plan.require_on_nodes("acceleration")) {}
  bool empty(std::size_t node) const { return !(mass[0][node] > 0); }

  const Column& mass;
  Column &force, &velocity, &acceleration;
};

/// When in the step (or at the end of a quasi-static one) a factor is taken: explicit steps see its mean, which is
/// exact for a linear course and does not ask on which side of a jump they begin.
template <int dim>
double loading_time(const StagePlan<dim>& plan) {
  const bool at_end = plan.stage.motion == SkeletonMotion::quasi_static;
  return at_end ? plan.clock.end : plan.clock.time + 0.5 * plan.clock.dt;
}

/// A factor in time [-]; one that is not given is 1.
inline double factor_at(const TimeRecord& factor, double time) {
  return factor.time.empty() ? 1.0 : value_until(factor, time);
}

}  // namespace wetfront::mpm
