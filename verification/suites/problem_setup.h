#pragma once

#include "mpm/problem.h"
#include "reports/record.h"

namespace wetfront::fem_reference {
struct RichardsProblem;
}

namespace wetfront::verification {

/// What is solved, as a case's page states it: the equation, then the values with their units.
template <int dim>
reports::Table problem_setup(const mpm::Problem<dim>& problem);
reports::Table problem_setup(const fem_reference::RichardsProblem& problem);

}  // namespace wetfront::verification
