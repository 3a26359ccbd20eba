#pragma once

#include "verification/suites/case.h"

#include <vector>

/// The families of cases of `wetfront verify mechanics`, one file each.
namespace wetfront::verification {

std::vector<Case> bar_cases();                  ///< a bar swings: period, energy; with points that cross cells
std::vector<Case> gravity_column_cases();       ///< settled under its own weight, small and large strain
std::vector<Case> manufactured_motion_cases();  ///< axis-aligned motion, generalized vortex: order in h
std::vector<Case> rotation_cases();             ///< a body turns: no stress from it

}  // namespace wetfront::verification
