#pragma once

#include "verification/suites/case.h"

#include <vector>

namespace wetfront::verification {

/// What the reference is held against: every gate R1 to R9 of the design and what lies between them, in the order of
/// the page. Heavy cases are in the list too; who runs it chooses.
std::vector<Case> reference_suite();

}  // namespace wetfront::verification
