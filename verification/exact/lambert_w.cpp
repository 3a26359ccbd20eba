#include "verification/exact/lambert_w.h"

#include <cmath>
#include <numbers>

#include "verification/exact/validity.h"

namespace wetfront::verification::exact {
namespace {

/// y - ln(1 + y); below 0.05 by its series, since the difference of two numbers y is only y^2/2.
double excess(double y) {
  if (y > 0.05) return y - std::log1p(y);
  double sum = 0, power = y * y;
  for (int k = 2; k < 16; ++k, power *= -y) sum += power / k;  // (0.05)^16/16 is 1e-17 of the first term
  return sum;
}

}  // namespace

double lower_branch(double tau) {
  require_point(tau >= 0, "lower branch of Lambert's W: tau < 0");
  if (tau == 0) return 0;
  // Starts: sqrt(2 tau) + 2 tau/3 near 0; tau + ln(1 + tau + ln(1 + tau)) beyond. Newton on a convex function: a start
  // at or above the root descends to it, one below overshoots once.
  double y = tau < 1 ? std::sqrt(2 * tau) + 2 * tau / 3 : tau + std::log1p(tau + std::log1p(tau));
  for (int i = 0; i < 60; ++i) {
    const double step = (excess(y) - tau) * (1 + y) / y;
    y -= step;
    if (std::abs(step) <= 1e-15 * y) break;
  }
  return y;
}

double lambert_w_lower(double x) {
  require_point(x < 0 && x >= -1 / std::numbers::e, "Lambert W_-1: x outside [-1/e, 0)");
  const double tau = -1 - std::log(-x);
  return -1 - lower_branch(tau > 0 ? tau : 0);
}

}  // namespace wetfront::verification::exact
