#pragma once

#include "mpm/laws/retention.h"

#include <algorithm>
#include <cmath>
#include <limits>

/// Water content as a function of pore pressure, and its inverse: what the two-velocity schemes update is the content,
/// the pressure follows from it.
namespace wetfront::mpm {

/// Suction [Pa] at an effective saturation in (0, 1]: the inverse of each retention curve.
inline double suction_at(const VanGenuchten& curve, double effective) {
  return curve.pressure_scale() * std::pow(std::pow(effective, -1 / curve.lambda()) - 1, 1 / curve.power());
}
inline double suction_at(const ExponentialCurve& curve, double effective) {
  return -curve.pressure_scale() * std::log(effective);
}

struct Effective {
  double value, slope;  ///< Se [-], dSe/ds [1/Pa]
};

/// Se and its slope together: half the powers of asking for one after the other, in the innermost loop of the scheme.
inline Effective effective_at(const VanGenuchten& curve, double s) {
  if (s <= 0) return {1, 0};
  const double x = curve.x(s), value = std::pow(1 + x, -curve.lambda());
  return {value, -curve.lambda() * curve.power() * x / s * value / (1 + x)};
}
inline Effective effective_at(const ExponentialCurve& curve, double s) {
  const double value = curve.effective(s);
  return {value, s > 0 ? -value / curve.pressure_scale() : 0.0};
}

/// Water mass per pore volume over the reference density: e(p) = S(p) (1 + p/K_l), on both sides of p = 0.
///
/// The liquid stays compressible in the unsaturated range too: with S(p) alone de/dp would vanish at p -> 0- and no
/// explicit step would be stable there.
template <RetentionCurve Curve>
class WaterContent {
 public:
  WaterContent(Curve curve, double bulk_modulus)
      : curve_(std::move(curve)), bulk_modulus_(bulk_modulus), s_min_(curve_.s_min()) {}

  double value(double p) const { return curve_.saturation(-p) * (1 + p / bulk_modulus_); }
  double slope(double p) const { return value_and_slope(p).slope; }
  double saturated() const { return curve_.s_max(); }

  /// p with e(p) = content; NaN where no pressure gives it (content not positive or not finite).
  ///
  /// Newton's method from the incompressible inverse, kept inside a bracket: e rises from 0 at p = -K_l to S_max at 0.
  double pressure_of(double content) const {
    const double s_max = curve_.s_max();
    if (content >= s_max) return (content / s_max - 1) * bulk_modulus_;
    if (!(content > 0)) return std::numeric_limits<double>::quiet_NaN();
    // Compressibility takes contents below S_min in very dry soil; there the start is merely a large suction.
    constexpr double driest = 1e-12;
    double low = -bulk_modulus_, high = 0;
    double p = std::max(low, -suction_at(curve_, std::max(driest, (content - s_min_) / (s_max - s_min_))));
    // Quadratic convergence: after a step of 1e-10 |p| what is left is far below round-off.
    for (int iteration = 0; iteration < 200; ++iteration) {
      const Effective here = value_and_slope(p);
      const double excess = here.value - content;
      (excess > 0 ? high : low) = p;
      const double next = p - excess / here.slope;
      const double step = (next >= low && next <= high ? next : 0.5 * (low + high)) - p;
      p += step;
      if (std::abs(step) <= 1e-10 * std::abs(p)) break;
    }
    return p;
  }

 private:
  /// e(p) and de/dp.
  Effective value_and_slope(double p) const {
    const Effective se = effective_at(curve_, -p);
    const double range = curve_.s_max() - s_min_, saturation = s_min_ + range * se.value, c = 1 + p / bulk_modulus_;
    return {saturation * c, saturation / bulk_modulus_ - range * se.slope * c};
  }

  Curve curve_;
  double bulk_modulus_, s_min_;
};

}  // namespace wetfront::mpm
