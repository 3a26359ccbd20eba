#include "verification/exact/iverson.h"

#include <cmath>
#include <numbers>

#include "verification/exact/erfcx.h"
#include "verification/exact/validity.h"

namespace wetfront::verification::exact {
namespace {

bool steep(double angle) {
  return angle > 0 && angle < std::numbers::pi / 2;
}

}  // namespace

// sqrt(t/pi) exp(-1/t) - erfc(1/sqrt t) = sqrt(t) ierfc(1/sqrt t)
double iverson_response(double t) {
  if (t <= 0) return 0;
  return std::sqrt(t) * ierfc(1 / std::sqrt(t));
}

double infinite_slope_safety(const SlopeStrength& s, double slope_angle, double depth, double head) {
  require_problem(steep(slope_angle), "infinite slope: angle outside (0, pi/2)");
  require_point(depth > 0, "infinite slope: depth <= 0");
  const double friction = std::tan(s.friction_angle);
  return friction / std::tan(slope_angle) +
         (s.cohesion - head * s.unit_weight_water * friction) /
             (s.unit_weight_soil * depth * std::sin(slope_angle) * std::cos(slope_angle));
}

IversonSolution::IversonSolution(const Iverson& problem)
    : p_(problem),
      beta_(std::cos(problem.slope_angle) * std::cos(problem.slope_angle) - problem.background),
      diffusion_(problem.diffusivity * std::cos(problem.slope_angle) * std::cos(problem.slope_angle)) {
  require_problem(steep(p_.slope_angle), "Iverson: angle outside (0, pi/2)");
  require_problem(p_.diffusivity > 0, "Iverson: D0 must be > 0");
  require_problem(p_.relative_intensity >= 0 && p_.duration >= 0, "Iverson: rain must not be negative");
}

/// Z R(t*) = sqrt(4 D t) ierfc(Z/sqrt(4 D t)): the same without dividing by Z, so that the surface is included.
double IversonSolution::transient(double depth, double t) const {
  if (t <= 0) return 0;
  const double reach = std::sqrt(4 * diffusion_ * t);
  return reach * ierfc(depth / reach);
}

double IversonSolution::head(double depth, double t) const {
  require_point(depth >= 0 && t >= 0, "Iverson: Z >= 0 (down) and t >= 0 are required");
  return beta_ * (depth - p_.water_table) +
         p_.relative_intensity * (transient(depth, t) - transient(depth, t - p_.duration));
}

bool IversonSolution::exceeds_beta_line(double depth, double t) const {
  return head(depth, t) > beta_ * depth;
}

}  // namespace wetfront::verification::exact
