#pragma once

#include "verification/compare/measure.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// The time of failure [s; not finite: it did not fail] here against that on `cells`, relative to the one here: none or
/// one measurement. Where only one of the two fails, the error is 1: nothing of it is known.
std::vector<Measurement> failure_on_two_meshes(double here, double there, const std::string& cells);

}  // namespace wetfront::verification
