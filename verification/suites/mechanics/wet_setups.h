#pragma once

#include "mpm/problem.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// Saturated soil in a column whose top is drained and loaded from t = 0 on, without weight; sides on rollers.
struct WetColumn {
  double height = 1, porosity = 0.4;
  double grain_density = 2650;
  double young = 10e6, poisson = 0.3;
  double conductivity = 1e-4;    ///< m/s
  double water_modulus = 0.2e9;  ///< Pa
  double load = 10e3;            ///< Pa
  int cells = 40;
  bool drained = true;  ///< the top lets water out

  double oedometer_modulus() const { return young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)); }
};

/// Water of 1 mPa s and 1000 kg/m3; `end` of the one stage and outputs at `times`.
mpm::Problem<2> wet_problem(const WetColumn& column, mpm::LiquidScheme scheme, const std::vector<double>& times);

/// Intrinsic permeability [m2] of a conductivity [m/s] with that water and g = 9.81 m/s2.
double intrinsic(double conductivity);

}  // namespace wetfront::verification
