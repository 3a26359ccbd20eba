#include "verification/suites/cost_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {

double cpu_at(const reports::Series& curve, double error) {
  for (std::size_t i = 1; i < curve.y.size(); ++i) {
    const double high = std::max(curve.y[i - 1], curve.y[i]), low = std::min(curve.y[i - 1], curve.y[i]);
    if (error > high || error < low || high == low) continue;
    const double r = std::log(error / curve.y[i - 1]) / std::log(curve.y[i] / curve.y[i - 1]);
    return curve.x[i - 1] * std::pow(curve.x[i] / curve.x[i - 1], r);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace wetfront::verification
