#pragma once

#include "mpm/problem.h"

namespace wetfront::mpm {

/// Numbers of a deforming skeleton that physics or the method does not allow, and things that only a deforming skeleton
/// can have in a problem whose soils are rigid. Throws CannotPlan.
template <int dim>
void check_skeleton(const Problem<dim>& problem);

}  // namespace wetfront::mpm
