#pragma once

#include "verification/suites/case.h"

#include <vector>

namespace wetfront::verification {

/// What the deforming skeleton is held against, alone and with its water, in the order of the page. Heavy cases are in
/// the list too; who runs it chooses.
std::vector<Case> mechanics_suite();

}  // namespace wetfront::verification
