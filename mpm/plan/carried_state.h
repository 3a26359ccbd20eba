#pragma once

#include "mpm/plan/stage_plan.h"

#include <map>

namespace wetfront::mpm {

/// Carried columns by "point.", "node." and "run." and their names, component after component, points in the order of
/// their cells; and "points per cell".
using Stored = std::map<std::string, std::vector<double>>;

/// All that is carried from step to step.
template <int dim>
Stored carried_state(const Fields<dim>& fields);

/// Gives points their cells, places and volumes back: conditions look for the surface of the body when the plan is
/// made, where it is, not where it began. The rest is for StagePlan::resume. Throws CannotPlan when the cells are
/// others.
template <int dim>
void restore_points(Fields<dim>& fields, const Stored& stored);

}  // namespace wetfront::mpm
