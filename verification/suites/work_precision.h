#pragma once

#include "reports/record.h"
#include "verification/suites/closed_form_case.h"

namespace wetfront::verification {

/// What accuracy in time costs: error against the same mesh at 1e-9 over CPU seconds, for BDF and for backward Euler,
/// over the tolerance. Space is left out on purpose: every point uses one mesh.
reports::Record work_precision(const ClosedFormCase& test, int cells);

}  // namespace wetfront::verification
