#pragma once

#include "reports/record.h"
#include "verification/suites/mechanics/motion.h"

#include <vector>

namespace wetfront::verification {

/// The material points at the chosen output times, counted from 0.
reports::Figure shape_of(const Motion<2>& motion, const std::vector<std::size_t>& times);

}  // namespace wetfront::verification
