#pragma once

#include "mpm/problem.h"

#include <cmath>
#include <concepts>

/// Water retention: degree of saturation S of suction s = -p [Pa]. For s <= 0 every curve is at S_max.
namespace wetfront::mpm {

template <class Law>
concept RetentionCurve = requires(const Law& law, double s) {
  { law.saturation(s) } -> std::convertible_to<double>;
  { law.slope(s) } -> std::convertible_to<double>;      ///< dS/ds <= 0 [1/Pa]
  { law.effective(s) } -> std::convertible_to<double>;  ///< Se = (S - S_min)/(S_max - S_min), Lee 2021 Eq. 6
  { law.effective_slope(s) } -> std::convertible_to<double>;
  { law.pressure_scale() } -> std::convertible_to<double>;  ///< Pa
  { law.s_min() } -> std::convertible_to<double>;
  { law.s_max() } -> std::convertible_to<double>;
};

/// Lee et al. 2021, Eq. 5; its slope is Eq. 8 with the exponent as a power (printed as a product).
class VanGenuchten {
 public:
  explicit VanGenuchten(const VanGenuchtenRetention& spec) : spec_(spec), power_(1 / (1 - spec.lambda)) {}

  double effective(double s) const { return s > 0 ? std::pow(1 + x(s), -spec_.lambda) : 1.0; }
  double effective_slope(double s) const {
    if (s <= 0) return 0;
    const double x_s = x(s);
    return -spec_.lambda * power_ * x_s / s * std::pow(1 + x_s, -spec_.lambda - 1);
  }
  double saturation(double s) const { return spec_.s_min + (spec_.s_max - spec_.s_min) * effective(s); }
  double slope(double s) const { return (spec_.s_max - spec_.s_min) * effective_slope(s); }
  double pressure_scale() const { return spec_.air_entry; }
  double s_min() const { return spec_.s_min; }
  double s_max() const { return spec_.s_max; }

  double lambda() const { return spec_.lambda; }
  double power() const { return power_; }  ///< 1/(1-lambda), van Genuchten's n
  /// x = (s/p0)^{1/(1-lambda)} for s > 0; Se^{1/lambda} = 1/(1+x).
  double x(double s) const { return std::pow(s / spec_.air_entry, power_); }

 private:
  VanGenuchtenRetention spec_;
  double power_;
};

/// Gardner: Se = exp(-s/p_c).
class ExponentialCurve {
 public:
  explicit ExponentialCurve(const ExponentialRetention& spec) : spec_(spec) {}

  double effective(double s) const { return s > 0 ? std::exp(-s / spec_.suction_scale) : 1.0; }
  double effective_slope(double s) const { return s > 0 ? -effective(s) / spec_.suction_scale : 0.0; }
  double saturation(double s) const { return spec_.s_min + (spec_.s_max - spec_.s_min) * effective(s); }
  double slope(double s) const { return (spec_.s_max - spec_.s_min) * effective_slope(s); }
  double pressure_scale() const { return spec_.suction_scale; }
  double s_min() const { return spec_.s_min; }
  double s_max() const { return spec_.s_max; }

 private:
  ExponentialRetention spec_;
};

static_assert(RetentionCurve<VanGenuchten> && RetentionCurve<ExponentialCurve>);

inline VanGenuchten make_law(const VanGenuchtenRetention& spec) {
  return VanGenuchten(spec);
}
inline ExponentialCurve make_law(const ExponentialRetention& spec) {
  return ExponentialCurve(spec);
}

}  // namespace wetfront::mpm
