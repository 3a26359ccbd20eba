#pragma once

#include "verification/suites/case.h"

#include <vector>

namespace wetfront::verification {

/// What the water of the material point method is held against, on a rigid skeleton: closed forms, the reference, and
/// its own schemes against each other.
std::vector<Case> hydraulics_suite();

}  // namespace wetfront::verification
