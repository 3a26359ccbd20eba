#pragma once

#include "mpm/laws/log_table.h"
#include "mpm/laws/retention.h"

#include <type_traits>

/// Relative permeability as a function of suction, given the retention curve of the same soil.
namespace wetfront::mpm {

/// Returns k_rel [-] and d k_rel / ds [1/Pa].
template <class Law, class Curve>
concept RelativePermeability = requires(const Law& law, const Curve& curve, double s) {
  { law(curve, s) } -> std::same_as<ValueAndSlope>;
};

/// Mualem 1976 on van Genuchten: Se^1/2 [1 - (1 - Se^{1/lambda})^lambda]^2 (Lee 2021 Eq. 7, exponent corrected).
struct Mualem {
  ValueAndSlope operator()(const VanGenuchten& curve, double s) const {
    if (s <= 0) return {};
    const double x = curve.x(s), lambda = curve.lambda();
    const double root = std::pow(1 + x, -0.5 * lambda);  // Se^1/2
    // 1 - (x/(1+x))^lambda without cancellation at large suction.
    const double bracket = -std::expm1(-lambda * std::log1p(1 / x));
    const double slope_of_log_x = curve.power() / s;
    const double root_slope = -0.5 * lambda * root * x / (1 + x) * slope_of_log_x;
    const double bracket_slope = -(1 - bracket) * lambda / (1 + x) * slope_of_log_x;
    return {root * bracket * bracket, root_slope * bracket * bracket + 2 * root * bracket * bracket_slope};
  }
};

/// Lee 2021 Eq. 7 as printed: Se^1/2 [1 - (1 - Se^{1/lambda})^2]; 46 times too permeable at 10 kPa.
struct PrintedMualem {
  ValueAndSlope operator()(const VanGenuchten& curve, double s) const {
    if (s <= 0) return {};
    const double x = curve.x(s), lambda = curve.lambda();
    const double root = std::pow(1 + x, -0.5 * lambda);
    const double w = x / (1 + x);
    const double slope_of_log_x = curve.power() / s;
    const double root_slope = -0.5 * lambda * root * w * slope_of_log_x;
    const double w_slope = w / (1 + x) * slope_of_log_x;
    return {root * (1 - w * w), root_slope * (1 - w * w) - 2 * root * w * w_slope};
  }
};

/// Mualem's formula fed with S in place of Se: a defect of other codes.
struct MualemOfSaturation {
  ValueAndSlope operator()(const VanGenuchten& curve, double s) const {
    if (s <= 0) return {};
    const double lambda = curve.lambda(), y = curve.saturation(s);
    const double y_power = std::pow(y, 1 / lambda);
    const double rest = 1 - y_power;
    if (rest <= 0) return {};
    const double bracket = 1 - std::pow(rest, lambda);
    const double root = std::sqrt(y);
    const double bracket_slope = std::pow(rest, lambda - 1) * y_power / y;
    const double slope_in_y = 0.5 / root * bracket * bracket + 2 * root * bracket * bracket_slope;
    return {root * bracket * bracket, slope_in_y * curve.slope(s)};
  }
};

/// Gardner 1958: exp(-s/p_k).
struct Exponential {
  double suction_scale;
  template <RetentionCurve Curve>
  ValueAndSlope operator()(const Curve&, double s) const {
    if (s <= 0) return {};
    const double value = std::exp(-s / suction_scale);
    return {value, -value / suction_scale};
  }
};

struct Constant {
  template <RetentionCurve Curve>
  ValueAndSlope operator()(const Curve&, double) const {
    return {};
  }
};

static_assert(RelativePermeability<Mualem, VanGenuchten> && RelativePermeability<PrintedMualem, VanGenuchten> &&
              RelativePermeability<MualemOfSaturation, VanGenuchten> &&
              RelativePermeability<Exponential, ExponentialCurve> && RelativePermeability<Constant, VanGenuchten>);

inline Mualem make_law(const MualemPermeability&) {
  return {};
}
inline PrintedMualem make_law(const PrintedMualemPermeability&) {
  return {};
}
inline MualemOfSaturation make_law(const MualemOfSaturationPermeability&) {
  return {};
}
inline Exponential make_law(const ExponentialPermeability& spec) {
  return {spec.suction_scale};
}
inline Constant make_law(const ConstantPermeability&) {
  return {};
}

}  // namespace wetfront::mpm
