#pragma once

#include "fem_reference/richards_problem.h"

#include <optional>
#include <string>

namespace wetfront::verification {

/// Names the content of a problem together with the code that solves it: the same text means the same solution.
/// Absent where the problem holds functions (closed forms), whose content cannot be read.
std::optional<std::string> problem_hash(const fem_reference::RichardsProblem& problem);

}  // namespace wetfront::verification
