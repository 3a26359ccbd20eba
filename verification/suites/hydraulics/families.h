#pragma once

#include "verification/suites/case.h"

#include <vector>

/// The families of cases of `wetfront verify hydraulics`, one file each.
namespace wetfront::verification {

std::vector<Case> column_cases();                   ///< the paper's columns, seven rains, two S_min
std::vector<Case> closed_form_water_cases();        ///< Srivastava-Yeh: one layer, two layers
std::vector<Case> time_step_cases();                ///< order in dt; BDF2 against backward Euler at equal cost
std::vector<Case> celia_water_cases();              ///< Celia: sand, New Mexico soil
std::vector<Case> broadbridge_white_water_cases();  ///< profiles, ponding
std::vector<Case> layer_cases();                    ///< a thousandfold contrast
std::vector<Case> plane_cases();                    ///< sections: the flume, a levee
std::vector<Case> surface_cases();                  ///< a surface inside the top cell
std::vector<Case> slope_cases();                    ///< sloping layers
std::vector<Case> scheme_cases();                   ///< the schemes against each other over windows
std::vector<Case> work_precision_water_cases();     ///< error over CPU seconds, all schemes

}  // namespace wetfront::verification
