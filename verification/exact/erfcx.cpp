#include "verification/exact/erfcx.h"

#include <cmath>
#include <numbers>

#include "verification/exact/validity.h"

namespace wetfront::verification::exact {
namespace {

/// Laplace's continued fraction x + (1/2)/(x + 1/(x + (3/2)/(x + ...))) (Abramowitz & Stegun 7.1.14), cut after `n`.
/// sqrt(pi) erfcx(x) is its reciprocal.
double laplace_fraction(double x, int n) {
  double tail = x;
  for (int k = n; k >= 1; --k) tail = x + 0.5 * k / tail;
  return tail;
}

}  // namespace

double erfcx(double x) {
  require_point(x >= -26, "erfcx: overflow below -26");
  // Below 3 exp(x^2) erfc(x) costs x^2 eps = 2e-15; above, 60 levels leave less than 1e-16 (see the test).
  if (x < 3) return std::exp(x * x) * std::erfc(x);
  return std::numbers::inv_sqrtpi / laplace_fraction(x, 60);
}

double ierfc(double x) {
  require_point(x >= 0, "ierfc: x < 0");
  if (x < 3) return std::exp(-x * x) * std::numbers::inv_sqrtpi - x * std::erfc(x);
  // 1 - x/(x + r) = r/(x + r) with r = (1/2)/(x + 1/(x + ...)), the fraction's tail.
  double tail = x;
  for (int k = 60; k >= 2; --k) tail = x + 0.5 * k / tail;
  const double r = 0.5 / tail;
  return std::exp(-x * x) * std::numbers::inv_sqrtpi * r / (x + r);
}

}  // namespace wetfront::verification::exact
