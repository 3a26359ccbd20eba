#pragma once

#include "fem_reference/soil/soil_curves.h"

#include <functional>
#include <vector>

namespace wetfront::fem_reference {

/// Phi(psi), the integral of K over the head from the dry end to psi [m2/s] (Kirchhoff's potential): its difference
/// over that of the heads is the mean of K over a piece on which psi is linear. Cubics of log Phi in
/// log(1 + suction / 1 mm), so that it holds relative to itself over all decades of K; the slope is theirs.
class ConductivityIntegral {
 public:
  ConductivityIntegral() = default;
  /// `conductivity(psi)`: K [m/s], constant for psi >= 0.
  explicit ConductivityIntegral(const std::function<double(double)>& conductivity);
  ValueAndSlope operator()(double head) const;

 private:
  double saturated_ = 0;                   ///< K(0)
  std::vector<double> logarithm_, slope_;  ///< log Phi at the nodes; with respect to the table's coordinate times width
};

}  // namespace wetfront::fem_reference
