#pragma once

#include "mpm/problem.h"

namespace wetfront::mpm {

/// Every number of the problem is one that the physics allows: porosity in (0, 1), S_min < S_max <= 1, rain >= 0, cells
/// that are not turned inside out, ... Throws CannotPlan naming the entry.
template <int dim>
void check_numbers(const Problem<dim>& problem);

}  // namespace wetfront::mpm
