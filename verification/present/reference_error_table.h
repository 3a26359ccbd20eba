#pragma once

#include "reports/record.h"
#include "verification/compare/measure.h"

#include <vector>

namespace wetfront::verification {

/// What the reference does not know about each quantity, and how its meshes approach each other.
reports::Table reference_error_table(const std::vector<Measurement>& measurements);

}  // namespace wetfront::verification
