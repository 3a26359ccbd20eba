#pragma once

#include "mpm/coupling/relaxation.h"

namespace wetfront::mpm {

/// A body that has become weaker comes to rest with the water as the state has it: pore stress, suction and weight of
/// water act on the skeleton (WaterPull) and do not change. One step of the plan is one relaxation.
template <int dim>
class WeakenedRest : public Effect<dim> {
 public:
  WeakenedRest(Origin origin, std::shared_ptr<SkeletonCycle<dim>> cycle)
      : Effect<dim>("rest of a weakened body", std::move(origin),
                    "div(sigma' - chi p I) + rho g = 0, p as it is; mpm/coupling/README.md section 11"),
        cycle_(std::move(cycle)) {}
  void join(StagePlan<dim>& plan) override;

 private:
  std::shared_ptr<SkeletonCycle<dim>> cycle_;
  std::unique_ptr<Relaxer<dim>> relaxer_;
};

}  // namespace wetfront::mpm
