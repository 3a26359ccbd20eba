#include "verification/exact/soil_strength.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/exact/validity.h"

namespace wetfront::verification::exact {
namespace {

void require_angle(double angle) {
  require_problem(angle >= 0 && angle < std::numbers::pi / 2, "soil strength: angles lie in [0, pi/2)");
}

/// N = tan^2(pi/4 + phi/2)
double flow_number(double friction) {
  require_angle(friction);
  return (1 + std::sin(friction)) / (1 - std::sin(friction));
}

double davis_factor(double friction, double dilatancy) {
  require_angle(friction);
  require_angle(std::abs(dilatancy));  // < 0: soil that shrinks when sheared
  return std::cos(dilatancy) / (1 - std::sin(dilatancy) * std::sin(friction));
}

}  // namespace

double triaxial_strength(double friction, double cohesion, double confinement) {
  const double n = flow_number(friction);
  return n * confinement + 2 * cohesion * std::sqrt(n);
}

double critical_slope_compression(double friction) {
  require_angle(friction);
  return 6 * std::sin(friction) / (3 - std::sin(friction));
}

double critical_slope_extension(double friction) {
  require_angle(friction);
  return 6 * std::sin(friction) / (3 + std::sin(friction));
}

double davis_friction(double friction, double dilatancy) {
  return davis_factor(friction, dilatancy) * std::sin(friction);
}

double davis_cohesion(double friction, double dilatancy, double cohesion) {
  return davis_factor(friction, dilatancy) * std::cos(friction) * cohesion;
}

/// On a plane at vertical depth z: sigma_n = gamma z cos^2 beta, tau = gamma z sin beta cos beta.
double safety_of(const DrySlope& s) {
  require_angle(s.slope);
  require_problem(s.slope > 0 && s.unit_weight > 0 && s.depth > 0, "dry slope: slope, weight and depth must be > 0");
  const double load = s.unit_weight * s.depth * std::cos(s.slope);
  return (davis_cohesion(s.friction, s.dilatancy, s.cohesion) +
          load * std::cos(s.slope) * davis_friction(s.friction, s.dilatancy)) /
         (load * std::sin(s.slope));
}

double bearing_factor_surcharge(double friction) {
  return std::exp(std::numbers::pi * std::tan(friction)) * flow_number(friction);
}

double bearing_factor_cohesion(double friction) {
  if (friction == 0) return std::numbers::pi + 2;
  return (bearing_factor_surcharge(friction) - 1) / std::tan(friction);
}

double sliding_acceleration(double slope, double friction_coefficient, double gravity) {
  require_angle(slope);
  return std::max(0.0, gravity * (std::sin(slope) - friction_coefficient * std::cos(slope)));
}

double cam_clay_undrained_mean_stress(double p0, double compression, double swelling) {
  require_problem(p0 > 0 && swelling > 0 && compression > swelling, "Cam-Clay: 0 < kappa < lambda and p0 > 0");
  return p0 * std::exp2(-(1 - swelling / compression));
}

}  // namespace wetfront::verification::exact
