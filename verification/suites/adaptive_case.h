#pragma once

#include "fem_reference/richards_problem.h"
#include "verification/suites/case.h"

#include <vector>

namespace wetfront::verification {

/// Dry soil (Celia's New Mexico, -10 m) in a square of 0.6 m, wetted for 6 h through the left quarter of its top, held
/// at -0.75 m: a sharp front in two dimensions. `cells` per direction, a multiple of 4.
fem_reference::RichardsProblem strip_infiltration(int cells);

/// What adaptivity buys: uniform meshes and meshes that follow the front, against a still finer uniform one.
std::vector<Case> adaptive_cases();

}  // namespace wetfront::verification
