#pragma once

#include "verification/suites/closed_form_case.h"

#include <vector>

namespace wetfront::verification {

/// The closed forms that the reference is held against (design gates R2, R3, R7).
std::vector<ClosedFormCase> reference_suite();

}  // namespace wetfront::verification
