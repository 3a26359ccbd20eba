#include "verification/exact/generalized_vortex.h"

#include <cmath>
#include <numbers>

#include "verification/exact/validity.h"

namespace wetfront::verification::exact {

GeneralizedVortexSolution::GeneralizedVortexSolution(const GeneralizedVortex& p) : p_(p) {
  require_problem(p.inner > 0 && p.outer > p.inner && p.duration > 0 && p.shear_modulus > 0 && p.density > 0,
                  "generalized vortex: 0 < Ri < Ro and positive duration, modulus and density are required");
}

GeneralizedVortexSolution::Profile GeneralizedVortexSolution::profile(double radius) const {
  const double width = p_.outer - p_.inner, s = (radius - 0.5 * (p_.inner + p_.outer)) / width;
  if (std::abs(s) >= 0.5) return {0, 0, 0};
  return {1 - 8 * s * s + 16 * s * s * s * s, (-16 * s + 64 * s * s * s) / width,
          (-16 + 192 * s * s) / (width * width)};
}

GeneralizedVortexSolution::Time GeneralizedVortexSolution::in_time(double t) const {
  const double rate = std::numbers::pi / p_.duration;
  return {p_.amplitude * std::sin(rate * t), p_.amplitude * rate * std::cos(rate * t),
          -p_.amplitude * rate * rate * std::sin(rate * t)};
}

double GeneralizedVortexSolution::angle(const Vector& x, double t) const {
  return in_time(t).value * profile(std::hypot(x[0], x[1])).value;
}

GeneralizedVortexSolution::Vector GeneralizedVortexSolution::position(const Vector& x, double t) const {
  const double c = std::cos(angle(x, t)), s = std::sin(angle(x, t));
  return {c * x[0] - s * x[1], s * x[0] + c * x[1]};
}

GeneralizedVortexSolution::Vector GeneralizedVortexSolution::velocity(const Vector& x, double t) const {
  const Vector at = position(x, t);
  const double turning = in_time(t).rate * profile(std::hypot(x[0], x[1])).value;
  return {-turning * at[1], turning * at[0]};
}

GeneralizedVortexSolution::Vector GeneralizedVortexSolution::body_force(const Vector& x, double t) const {
  const double radius = std::hypot(x[0], x[1]);
  const Profile h = profile(radius);
  if (radius == 0) return {0, 0};
  const Time g = in_time(t);
  const double stiffness = p_.shear_modulus / p_.density;
  const double radial = -radius * std::pow(g.rate * h.value, 2) + stiffness * radius * std::pow(g.value * h.slope, 2);
  const double tangential =
      radius * g.acceleration * h.value - stiffness * g.value * (3 * h.slope + radius * h.curvature);
  const Vector at = position(x, t);
  return {(radial * at[0] - tangential * at[1]) / radius, (radial * at[1] + tangential * at[0]) / radius};
}

}  // namespace wetfront::verification::exact
