#include "verification/exact/de_boer.h"

#include <cmath>
#include <numbers>

#include "verification/exact/quadrature.h"
#include "verification/exact/validity.h"

namespace wetfront::verification::exact {
namespace {

/// exp(-x) I_0(x). Hankel's expansion beyond 30, where its terms fall below 1e-16 before they grow again.
double scaled_bessel(double x) {
  if (x < 30) return std::exp(-x) * std::cyl_bessel_i(0.0, x);
  double term = 1, sum = 1;
  for (int k = 1; k < 25; ++k) {
    term *= (2.0 * k - 1) * (2.0 * k - 1) / (8.0 * k * x);
    sum += term;
    if (term < 1e-17) break;
  }
  return sum / std::sqrt(2 * std::numbers::pi * x);
}

}  // namespace

DeBoerSolution::DeBoerSolution(const DeBoerColumn& p) : p_(p), modulus_(p.lame + 2 * p.shear_modulus) {
  require_problem(modulus_ > 0 && p.solid_fraction > 0 && p.solid_fraction < 1 && p.grain_density > 0 &&
                      p.water_density > 0 && p.conductivity > 0 && p.water_unit_weight > 0 && p.load,
                  "de Boer: moduli, fractions, densities and conductivity must be > 0, and there must be a load");
  const double solid = p.solid_fraction, fluid = 1 - solid;
  a_ = (fluid * fluid * solid * p.grain_density + solid * solid * fluid * p.water_density) / (modulus_ * fluid * fluid);
  b_ = p.water_unit_weight / (p.conductivity * modulus_);
}

double DeBoerSolution::wave_speed() const {
  return 1 / std::sqrt(a_);
}

double DeBoerSolution::displacement(double z, double t) const {
  require_point(z >= 0, "de Boer: z < 0");
  const double arrival = std::sqrt(a_) * z, rate = b_ / (2 * a_);
  if (t <= arrival) return 0;
  const auto kernel = [&](double tau) {
    const double behind = std::sqrt(std::max(0.0, (tau - arrival) * (tau + arrival)));
    return p_.load(t - tau) * std::exp(-rate * (tau - behind)) * scaled_bessel(rate * behind);
  };
  return integrate(kernel, arrival, t) / (std::sqrt(a_) * modulus_);
}

}  // namespace wetfront::verification::exact
