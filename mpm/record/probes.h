#pragma once

#include "mpm/plan/stage_plan.h"

namespace wetfront::mpm {

/// Gauges: nodal pressure interpolated at fixed places, and the saturation of the soil there.
template <int dim>
class Probes : public Effect<dim> {
 public:
  explicit Probes(Origin origin) : Effect<dim>("probes", std::move(origin), "p(x) = sum_i N_i(x) p_i") {}
  /// Throws CannotPlan when a probe lies outside the soil.
  void join(StagePlan<dim>& plan) override;
};

}  // namespace wetfront::mpm
