#include "verification/exact/terzaghi.h"

#include <cmath>
#include <numbers>

#include "verification/exact/bisect.h"
#include "verification/exact/erfcx.h"
#include "verification/exact/validity.h"

namespace wetfront::verification::exact {
namespace {

constexpr double early = 0.2;  // there 6 terms of either form reach 1e-20

double frequency(int k) {
  return (2 * k + 1) * std::numbers::pi / 2;
}

}  // namespace

double terzaghi_pressure(double depth_ratio, double time_factor) {
  require_point(depth_ratio >= 0 && depth_ratio <= 1, "Terzaghi: Z outside [0, 1]");
  require_point(time_factor >= 0, "Terzaghi: T < 0");
  if (time_factor == 0) return depth_ratio > 0 ? 1 : 0;
  double sum = 0;
  if (time_factor >= early) {
    for (int k = 0; k < 12; ++k)
      sum += 2 / frequency(k) * std::sin(frequency(k) * depth_ratio) *
             std::exp(-frequency(k) * frequency(k) * time_factor);
    return sum;
  }
  // images of the drained plane, alternately across the closed base and the top
  const double reach = 2 * std::sqrt(time_factor);
  for (int k = 0; k < 8; ++k)
    sum += (k % 2 == 0 ? 1 : -1) *
           (std::erfc((2 * k + depth_ratio) / reach) + std::erfc((2 * k + 2 - depth_ratio) / reach));
  return 1 - sum;
}

double terzaghi_degree(double time_factor) {
  require_point(time_factor >= 0, "Terzaghi: T < 0");
  if (time_factor == 0) return 0;
  double sum = 0;
  if (time_factor >= early) {
    for (int k = 0; k < 12; ++k)
      sum += 2 / (frequency(k) * frequency(k)) * std::exp(-frequency(k) * frequency(k) * time_factor);
    return 1 - sum;
  }
  const double root = std::sqrt(time_factor);
  for (int k = 1; k < 8; ++k) sum += (k % 2 == 0 ? 1 : -1) * ierfc(k / root);
  return 2 * root * (std::numbers::inv_sqrtpi + 2 * sum);
}

double terzaghi_time_factor(double degree) {
  require_point(degree >= 0 && degree < 1, "Terzaghi: U outside [0, 1)");
  if (degree == 0) return 0;
  return bisect([&](double t) { return terzaghi_degree(t) > degree; }, 0, 20);  // 1 - U(20) = 3e-22
}

TerzaghiSolution::TerzaghiSolution(const Terzaghi& p) : p_(p) {
  require_problem(p.thickness > 0 && p.permeability > 0 && p.unit_weight_water > 0 && p.oedometer_modulus > 0,
                  "Terzaghi: thickness, permeability, unit weight and modulus must be > 0");
  require_problem(p.porosity >= 0 && p.porosity < 1 && p.water_modulus > 0,
                  "Terzaghi: porosity in [0, 1) and a positive water modulus are required");
  const double mv = 1 / p.oedometer_modulus, storage = p.porosity / p.water_modulus;
  cv_ = p.permeability / (p.unit_weight_water * (mv + storage));
  p0_ = p.load / (1 + storage / mv);
}

double TerzaghiSolution::pressure(double depth, double t) const {
  return p0_ * terzaghi_pressure(depth / p_.thickness, cv_ * t / (p_.thickness * p_.thickness));
}

/// m_v times the integral of sigma' = sigma - p: what the skeleton carries at once, then the rest as p drains.
double TerzaghiSolution::settlement(double t) const {
  const double degree = terzaghi_degree(cv_ * t / (p_.thickness * p_.thickness));
  return p_.thickness / p_.oedometer_modulus * (p_.load - p0_ * (1 - degree));
}

}  // namespace wetfront::verification::exact
