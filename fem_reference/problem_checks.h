#pragma once

#include "fem_reference/richards_problem.h"

namespace wetfront::fem_reference {

/// Throws std::invalid_argument "<entry>: <problem> (<why it is one>)" for a problem that makes no sense.
void check_problem(const RichardsProblem& problem);

}  // namespace wetfront::fem_reference
