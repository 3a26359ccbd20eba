#include "verification/exact/vibrating_bar.h"

#include <cmath>
#include <numbers>

#include "verification/exact/validity.h"

namespace wetfront::verification::exact {

VibratingBarSolution::VibratingBarSolution(const VibratingBar& p) : p_(p) {
  require_problem(p.length > 0 && p.young > 0 && p.density > 0 && p.mode > 0,
                  "vibrating bar: length, modulus, density and mode must be > 0");
  wave_ = (2 * p.mode - 1) * std::numbers::pi / (2 * p.length);
  frequency_ = wave_ * std::sqrt(p.young / p.density);
}

double VibratingBarSolution::period() const {
  return 2 * std::numbers::pi / frequency_;
}

double VibratingBarSolution::displacement(double x, double t) const {
  return p_.velocity / frequency_ * std::sin(wave_ * x) * std::sin(frequency_ * t);
}

double VibratingBarSolution::velocity(double x, double t) const {
  return p_.velocity * std::sin(wave_ * x) * std::cos(frequency_ * t);
}

double VibratingBarSolution::stress(double x, double t) const {
  return p_.young * wave_ * p_.velocity / frequency_ * std::cos(wave_ * x) * std::sin(frequency_ * t);
}

double VibratingBarSolution::mean_velocity(double t) const {
  return p_.velocity / (wave_ * p_.length) * std::cos(frequency_ * t);
}

double VibratingBarSolution::energy() const {
  return p_.density * p_.velocity * p_.velocity * p_.length / 4;  // the mean of sin^2 is a half
}

}  // namespace wetfront::verification::exact
