#pragma once

#include "mpm/plan/stage_plan.h"

#include <memory>

namespace wetfront::mpm {

/// Makes the plan of a stage: joins exactly the effects that the problem calls for, and no other.
///   soils without / with `elastic`   -> rigid / elastic skeleton
///   gravity that is not zero         -> gravity
///   stage.liquid                     -> seepage | two-velocity pore liquid
///   water_boundary, fixities, probes -> rainfall, prescribed pressure, free drainage, fixities, probes
/// Throws CannotPlan when they do not go together.
template <int dim>
std::unique_ptr<StagePlan<dim>> make_plan(const Problem<dim>& problem, std::size_t stage, Fields<dim>& fields);

/// The plan of one relaxation in a quasi-static stage with the water as it is (coupling/weakened_rest.h): skeleton,
/// gravity and what holds on its sides alone.
template <int dim>
std::unique_ptr<StagePlan<dim>> make_plan_of_weakened_rest(const Problem<dim>& problem, std::size_t stage,
                                                           Fields<dim>& fields);

/// Throws CannotPlan when the problem contradicts itself (no stages, lengths that do not match, ...).
template <int dim>
void check(const Problem<dim>& problem);

}  // namespace wetfront::mpm
