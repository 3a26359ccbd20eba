#pragma once

#include "verification/suites/case.h"

#include <vector>

/// The families of cases of `wetfront verify hydraulics`, one file each.
namespace wetfront::verification {

std::vector<Case> column_cases();             ///< the paper's columns, seven rains, two S_min
std::vector<Case> closed_form_water_cases();  ///< Srivastava-Yeh: one layer, two layers
std::vector<Case> time_step_cases();          ///< order in dt; BDF2 against backward Euler at equal cost

}  // namespace wetfront::verification
