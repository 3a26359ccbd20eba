#include "verification/exact/broadbridge_white.h"

#include <cmath>
#include <limits>

#include "verification/exact/bisect.h"
#include "verification/exact/erfcx.h"
#include "verification/exact/validity.h"

namespace wetfront::verification::exact {

BroadbridgeWhite::BroadbridgeWhite(double c, double flux)
    : c_(c), flux_(flux), b_(c * (c - 1)), ponding_(std::numeric_limits<double>::infinity()) {
  require_problem(c > 1 && flux > 0, "Broadbridge-White: C must exceed 1 and the flux must be positive");
  if (flux <= 1) return;  // Theta(0, t) then tends to K^-1(R) <= 1
  double late = 1;
  while (saturation_at(0, late) < 1) {
    late *= 2;
    require_problem(flux * late < 600, "Broadbridge-White: R is too close to 1 for the time to ponding");
  }
  ponding_ = bisect([&](double t) { return saturation_at(0, t) > 1; }, 0, late);
}

/// phi and phi_Y. In G_R - G_0 the Gaussian parts of the Y-derivatives are equal (r^2 - c = R^2/4b for both) and drop
/// out; e^{yr} erfc(.) is written with erfcx because its factors overflow and underflow.
BroadbridgeWhite::Potential BroadbridgeWhite::potential(double y_distance, double t) const {
  const double y = y_distance / std::sqrt(b_), root = std::sqrt(t), tilt = flux_ / (2 * b_);
  const double gauss = std::exp(-y * y / (4 * t) - flux_ * flux_ * t / (4 * b_) - tilt * y_distance);
  double difference = 0, slope = 0;
  for (double c : {flux_, 0.0}) {
    const double r = std::sqrt(flux_ * flux_ / (4 * b_) + c), sign = c > 0 ? 1 : -1;
    const double near = y / (2 * root) - r * root;
    // e^{ct - yr} erfc(near) = e^{-y^2/4t - R^2 t/4b} erfcx(near); the left form where erfcx would overflow.
    const double first = near > 0 ? gauss * erfcx(near) : std::exp(c * t - y * r - tilt * y_distance) * std::erfc(near);
    const double second = gauss * erfcx(y / (2 * root) + r * root);
    difference += sign * 0.5 * (first + second);
    slope += sign * 0.5 * r * (second - first) / std::sqrt(b_);
  }
  return {1 + difference, slope - tilt * difference};
}

double BroadbridgeWhite::saturation_at(double y_distance, double t) const {
  const Potential p = potential(y_distance, t);
  // C - C/(1 - x) with x = phi_Y/phi <= 0 is -C x/(1 - x): no cancellation where Theta is small.
  const double x = p.slope / p.phi;
  return -c_ * x / (1 - x);
}

void BroadbridgeWhite::require_time(double t) const {
  require_point(t >= 0, "Broadbridge-White: t < 0");
  require_point(t <= ponding_, "Broadbridge-White: the surface has ponded; the constant flux solution ends there");
  require_point(flux_ * t <= 600, "Broadbridge-White: R t > 600 overflows");
}

double BroadbridgeWhite::surface_saturation(double t) const {
  require_time(t);
  return t == 0 ? 0 : saturation_at(0, t);
}

double BroadbridgeWhite::saturation(double z, double t) const {
  require_time(t);
  require_point(z >= 0, "Broadbridge-White: z < 0 (z is the depth)");
  if (t == 0) return 0;
  const auto depth = [&](double y) { return (y + flux_ * t - std::log(potential(y, t).phi)) / c_; };
  // dz/dY = 1/(C - Theta) lies in [1/C, 1/(C - 1)]: Y(z) lies in [(C - 1) z, C z].
  return saturation_at(bisect([&](double y) { return depth(y) > z; }, 0, c_ * z + 1e-300), t);
}

double BroadbridgeWhite::head(double z, double t) const {
  const double theta = saturation(z, t);
  require_point(theta >= 1e-6, "Broadbridge-White: too dry here for the head to be known");
  return head_of(theta);
}

double BroadbridgeWhite::diffusivity(double theta) const {
  return b_ / ((c_ - theta) * (c_ - theta));
}

double BroadbridgeWhite::conductivity(double theta) const {
  return (c_ - 1) * theta * theta / (c_ - theta);
}

double BroadbridgeWhite::head_of(double theta) const {
  require_point(theta > 0 && theta <= 1, "Broadbridge-White: Theta outside (0, 1]");
  return 1 - 1 / theta - std::log((c_ - theta) / ((c_ - 1) * theta)) / c_;
}

}  // namespace wetfront::verification::exact
