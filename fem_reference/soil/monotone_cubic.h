#pragma once

#include "fem_reference/soil/soil_curves.h"

#include <vector>

namespace wetfront::fem_reference {

/// Interpolates points by cubics that rise or fall only where the points do, with a continuous slope (Fritsch &
/// Carlson 1980, SIAM J. Numer. Anal. 17:238). Constant, with slope 0, beyond the first and the last point.
class MonotoneCubic {
 public:
  MonotoneCubic() = default;
  /// At least two points, x ascending.
  MonotoneCubic(std::vector<double> x, std::vector<double> y);
  ValueAndSlope operator()(double x) const;

 private:
  std::vector<double> x_, y_, slope_;
};

}  // namespace wetfront::fem_reference
