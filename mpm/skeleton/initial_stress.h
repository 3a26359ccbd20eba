#pragma once

#include "mpm/plan/stage_plan.h"

namespace wetfront::mpm {

/// InitialStress::k0. At each point, with sigma_v the total stress of what lies above (overburden.h) and the problem's
/// initial pressure p (of the scene or of another solver's field), tension-positive:
///
///     sigma'_v = -sigma_v + chi p,   sigma' = sigma'_v (u u^T) + K_0 sigma'_v (I - u u^T),   u against gravity.
///
/// In equilibrium under level ground to round-off (2 x 2 Gauss points); under slopes shear stress is missing and
/// relaxation finds it. Throws CannotPlan for laws whose stress follows from the deformation alone.
template <int dim>
class InitialStressEffect : public Effect<dim> {
 public:
  explicit InitialStressEffect(Origin origin)
      : Effect<dim>("initial stress", std::move(origin), "K_0 procedure; sigma' = sigma + chi p (Bishop 1959)") {}
  void join(StagePlan<dim>& plan) override;
};

}  // namespace wetfront::mpm
