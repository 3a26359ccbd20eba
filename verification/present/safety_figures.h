#pragma once

#include "mpm/coupling/strength_reduction.h"
#include "reports/record.h"
#include "verification/compare/slope_factors.h"

#include <optional>
#include <vector>

namespace wetfront::verification {

/// Factors of safety of one state.
struct SafetyRow {
  double time = 0;  ///< s
  mpm::SafetyFactor reduction;
  std::optional<SlopeFactors> slope;  ///< where the ground has a steepest part
};

/// Factors over time, with when each falls below one. Empty without rows.
std::vector<reports::Figure> safety_figures(const std::vector<SafetyRow>& rows);
/// The same in numbers, with what they cost.
reports::Table safety_table(const std::vector<SafetyRow>& rows);

}  // namespace wetfront::verification
