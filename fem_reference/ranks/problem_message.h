#pragma once

#include "fem_reference/richards_problem.h"

#include <vector>

namespace wetfront::fem_reference {

/// A problem as bytes for the other ranks of the same program, without its functions of place (not_shareable).
std::vector<char> pack(const RichardsProblem& problem);
RichardsProblem unpack(const std::vector<char>& message);

}  // namespace wetfront::fem_reference
