#pragma once

#include "fem_reference/richards_problem.h"

#include <vector>

namespace wetfront::verification {

/// lambda = 1 m, dtheta = 0.3, Ks = 1e-4 m/s: dimensionless times are in units of 3000 s.
namespace broadbridge_white_soil {
constexpr double c = 1.5, theta_n = 0.1, range = 0.3, conductivity = 1e-4, unit = range / conductivity;
}

/// A column of that soil, `depth` lengths deep, under the dimensionless `flux`; outputs at dimensionless `times`. The
/// closed form starts at Theta = 0, psi = -infinity; the column at -1000 m, that is Theta = 1e-3.
fem_reference::RichardsProblem broadbridge_white_column(double depth, int cells, double flux,
                                                        const std::vector<double>& times);

}  // namespace wetfront::verification
