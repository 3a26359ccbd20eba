#pragma once

#include "mpm/plan/stage_plan.h"

namespace wetfront::mpm {

/// Material points that are followed from their first places (Problem::riders), by those: points remember where they
/// began in "initial position". Pictures get the displacement of every point.
template <int dim>
class Riders : public Effect<dim> {
 public:
  explicit Riders(Origin origin) : Effect<dim>("riders", std::move(origin), "x(t), v(t) of material points") {}
  void join(StagePlan<dim>& plan) override;
};

}  // namespace wetfront::mpm
