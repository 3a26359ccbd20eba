#include "verification/exact/axis_aligned_motion.h"

#include <cmath>
#include <numbers>

#include "verification/exact/validity.h"

namespace wetfront::verification::exact {

using std::numbers::pi;

AxisAlignedSolution::AxisAlignedSolution(const AxisAlignedMotion& p) : p_(p) {
  require_problem(p.dim >= 1 && p.dim <= 3 && p.shear_modulus > 0 && p.lame >= 0 && p.density > 0 && p.speed > 0,
                  "axis-aligned motion: one to three axes, positive moduli, density and speed");
  require_problem(2 * pi * std::abs(p.amplitude) < 1, "axis-aligned motion: 2 pi A must stay below 1");
}

AxisAlignedSolution::Vector AxisAlignedSolution::displacement(const Vector& x, double t) const {
  Vector u{};
  for (int i = 0; i < p_.dim; ++i)
    u[i] = p_.amplitude * std::sin(2 * pi * x[i]) * std::sin(p_.speed * pi * t + p_.phase[i]);
  return u;
}

AxisAlignedSolution::Vector AxisAlignedSolution::velocity(const Vector& x, double t) const {
  Vector v{};
  for (int i = 0; i < p_.dim; ++i)
    v[i] = p_.amplitude * p_.speed * pi * std::sin(2 * pi * x[i]) * std::cos(p_.speed * pi * t + p_.phase[i]);
  return v;
}

AxisAlignedSolution::Vector AxisAlignedSolution::stretch(const Vector& x, double t) const {
  Vector f{1, 1, 1};
  for (int i = 0; i < p_.dim; ++i)
    f[i] += 2 * pi * p_.amplitude * std::cos(2 * pi * x[i]) * std::sin(p_.speed * pi * t + p_.phase[i]);
  return f;
}

double AxisAlignedSolution::log_volume(const Vector& stretch) const {
  return std::log(stretch[0] * stretch[1] * stretch[2]);
}

AxisAlignedSolution::Vector AxisAlignedSolution::body_force(const Vector& x, double t) const {
  const Vector u = displacement(x, t), f = stretch(x, t);
  const double volume = log_volume(f);
  Vector b{};
  for (int i = 0; i < p_.dim; ++i)
    b[i] = pi * pi * u[i] *
           (4 * p_.shear_modulus / p_.density - p_.speed * p_.speed -
            4 * (p_.lame * (volume - 1) - p_.shear_modulus) / (p_.density * f[i] * f[i]));
  return b;
}

AxisAlignedSolution::Vector AxisAlignedSolution::stress(const Vector& x, double t) const {
  const Vector f = stretch(x, t);
  const double volume = log_volume(f);
  Vector sigma{};
  for (int i = 0; i < 3; ++i) sigma[i] = (p_.lame * volume + p_.shear_modulus * (f[i] * f[i] - 1)) / std::exp(volume);
  return sigma;
}

}  // namespace wetfront::verification::exact
