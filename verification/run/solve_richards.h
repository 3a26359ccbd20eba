#pragma once

#include "fem_reference/richards_problem.h"
#include "verification/run/solve_reference.h"

#include <string>

namespace wetfront::verification {

/// Any problem of the reference's: taken from the store, or solved with `name` shown meanwhile and kept. One that gives
/// up is a result, which is not kept. Throws what the reference throws at a problem it refuses, and where the store
/// cannot be written.
Solved solve_richards(const fem_reference::RichardsProblem& problem, const std::string& name,
                      const ReferenceStore& store);

}  // namespace wetfront::verification
