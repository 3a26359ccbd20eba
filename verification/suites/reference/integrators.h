#pragma once

#include "fem_reference/richards_problem.h"

#include <string>

namespace wetfront::verification {

/// As the pages call it.
std::string integrator_name(fem_reference::Integrator integrator);

}  // namespace wetfront::verification
