#pragma once

#include "fem_reference/richards_problem.h"

namespace wetfront::fem_reference {

/// Throws std::invalid_argument naming the entry of a soil that makes no sense, and why.
void check_soils(const RichardsProblem& problem);

}  // namespace wetfront::fem_reference
