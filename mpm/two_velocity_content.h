#pragma once

#include "mpm/retention.h"

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

/// Water mass per pore volume over the reference density: e(p) = S(p) (1 + p/K_l), on both sides of p = 0.
///
/// The liquid stays compressible in the unsaturated range too: with S(p) alone de/dp would vanish at p -> 0- and no
/// explicit step would be stable there.
template <RetentionCurve Curve>
class WaterContent {
 public:
  WaterContent(Curve curve, double bulk_modulus)
      : curve_(std::move(curve)),
        bulk_modulus_(bulk_modulus),
        s_min_(curve_.saturation(std::numeric_limits<double>::infinity())) {}

  double value(double p) const { return curve_.saturation(-p) * (1 + p / bulk_modulus_); }
  double slope(double p) const {
    return curve_.saturation(-p) / bulk_modulus_ - curve_.slope(-p) * (1 + p / bulk_modulus_);
  }
  double saturated() const { return curve_.s_max(); }

  /// p with e(p) = content; NaN where no pressure gives it (content at or below S_min, or not finite).
  ///
  /// Newton's method from the incompressible inverse. For p < 0 the true content is below S(p), so that start lies left
  /// of the root, where e is concave near saturation and practically S elsewhere: the iterates rise monotonically.
  double pressure_of(double content) const {
    const double s_max = curve_.s_max();
    if (content >= s_max) return (content / s_max - 1) * bulk_modulus_;
    const double effective = (content - s_min_) / (s_max - s_min_);
    if (!(effective > 0)) return std::numeric_limits<double>::quiet_NaN();
    double p = -suction_at(curve_, effective);
    // Quadratic convergence: a step of 1e-10 |p| leaves an error far below round-off of the next evaluation.
    for (int iteration = 0; iteration < 50; ++iteration) {
      const double step = (content - value(p)) / slope(p);
      p = std::min(p + step, 0.0);
      if (std::abs(step) <= 1e-10 * std::abs(p)) break;
    }
    return p;
  }

 private:
  Curve curve_;
  double bulk_modulus_, s_min_;
};

}  // namespace wetfront::mpm
