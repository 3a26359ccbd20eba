#pragma once

#include "verification/suites/case.h"

#include <vector>

/// The families of cases of `wetfront verify mechanics`, one file each.
namespace wetfront::verification {

std::vector<Case> bar_cases();                  ///< a bar swings: period, energy; with points that cross cells
std::vector<Case> gravity_column_cases();       ///< settled under its own weight, small and large strain
std::vector<Case> manufactured_motion_cases();  ///< axis-aligned motion, generalized vortex: order in h
std::vector<Case> rotation_cases();             ///< a body turns: no stress from it
std::vector<Case> motion_work_cases();          ///< error over CPU seconds, scheme by scheme
std::vector<Case> material_path_cases();        ///< laws along paths of strain and stress
std::vector<Case> footing_cases();              ///< Prandtl
std::vector<Case> incline_cases();              ///< a block slides or sticks; an infinite slope
std::vector<Case> wide_block_cases();           ///< a wide one rests, slides and hops, beside finite elements
std::vector<Case> collapse_cases();             ///< dry columns fall

std::vector<Case> wet_column_cases();  ///< Terzaghi, de Boer, undrained loads

std::vector<Case> wet_block_cases();  ///< a wetted block flies: graded, as a whole, sheared

std::vector<Case> wet_collapse_cases();  ///< a saturated column falls

}  // namespace wetfront::verification
