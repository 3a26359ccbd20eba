#pragma once

#include "mpm/plan/stage_plan.h"

#include <string>

namespace wetfront::mpm {

/// What a stage is expected to take: the sum over time of 1/step, before anything is run.
///
/// An unconditionally stable stage says itself how many steps its accuracy needs. A conditionally stable one takes
/// duration / limit, and its limit depends on how wet the soil is. Three states are looked at: the initial one; the
/// wetted one, where the strongest rain meets K(p) = I (saturated from K_s on, and where pressures are prescribed);
/// and the full one, p >= 0. While a front travels dry and wetted soil are both there, so the smaller limit counts;
/// where nothing can drain, water begins to stand once the rain has wetted all soil. An estimate, good to a factor of
/// about four: redistribution after rain is not followed.
struct StageEstimate {
  double steps = 0, cpu_seconds = 0;
  double step = 0;        ///< s, the smallest of the limits met, times the stage's safety
  bool by_limit = false;  ///< steps follow from a stability limit
};

/// `plan` is that of the stage, entered. Throws CannotPlan.
template <int dim>
StageEstimate estimate(const StagePlan<dim>& plan);

/// Throws CannotPlan when the conditionally stable stages alone need more CPU than Problem::cpu_budget.
template <int dim>
void check_cost(const Problem<dim>& problem);

}  // namespace wetfront::mpm
