#pragma once

#include "fem_reference/richards_problem.h"

#include <vector>

namespace wetfront::fem_reference {

/// A problem as bytes: for the other ranks of the same program, and to name its content. All but its functions of
/// place (`source`, HeadSide::varying), which have no bytes. Equal problems give equal bytes.
std::vector<char> pack(const RichardsProblem& problem);
RichardsProblem unpack(const std::vector<char>& message);

}  // namespace wetfront::fem_reference
