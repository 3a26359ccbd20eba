#pragma once

#include "verification/suites/hard/hard_case.h"

#include <vector>

/// The rows of the matrix, one function per file.
namespace wetfront::verification {

std::vector<HardCase> dry_rows();      ///< very dry starts, fine soils, thresholds of saturation
std::vector<HardCase> layer_rows();    ///< contrasts of conductivity, thin and graded cells
std::vector<HardCase> water_rows();    ///< compressibility, closed boxes, starts above zero pressure
std::vector<HardCase> rain_rows();     ///< intensities, records, drizzle, no rain at all, ponding
std::vector<HardCase> surface_rows();  ///< surfaces inside cells, mesh borders, thin covers
std::vector<HardCase> carried_rows();  ///< blocks that slide through cells
std::vector<HardCase> invalid_rows();  ///< scenes that make no sense

}  // namespace wetfront::verification
