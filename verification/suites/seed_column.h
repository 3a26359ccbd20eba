#pragma once

#include "fem_reference/richards_problem.h"

namespace wetfront::verification {

/// The column of the seed paper's sand (Lee et al. 2021, Table 1; benchmarks.md section 4): 1.2 m over an impermeable
/// base, suction hydrostatic and at most 10 kPa at the start, rain on top.
struct SeedColumn {
  double rain;           ///< m/s
  double s_min = 0.087;  ///< 0.87 as printed

  /// Seconds of rain that fill the pores: storage deficit / rain.
  double filling_time() const;
  /// Outputs at these shares of the filling time; ends at the last one.
  fem_reference::RichardsProblem problem(int cells, const std::vector<double>& shares) const;
};

constexpr double seed_conductivity = 3e-11 * 9810 / 1e-3;  ///< ks [m/s]

}  // namespace wetfront::verification
