#pragma once

namespace wetfront::verification::exact {

/// van Genuchten 1980 (SSSAJ 44:892) retention and Mualem conductivity, written here a second time so that the closed
/// forms share no formula with either solver. Any consistent units; h <= 0 unsaturated, h > 0 saturated.
///   Se = [1 + (-alpha h)^n]^-m, m = 1 - 1/n;  K = Ks Se^1/2 [1 - (1 - Se^{1/m})^m]^2.
/// All differences of nearly equal powers go through log1p and expm1: relative accuracy holds in the dry end too.
struct VanGenuchten {
  double theta_r, theta_s;
  double alpha;         ///< 1/length
  double n;             ///< > 1
  double conductivity;  ///< Ks [length/time]

  double saturation(double head) const;             ///< Se in (0, 1]
  double content(double head) const;                ///< theta
  double relative_conductivity(double head) const;  ///< K/Ks
  double capacity(double head) const;               ///< dtheta/dh
  /// h(Se); std::domain_error outside (0, 1].
  double head_of_saturation(double saturation) const;
  /// h where K = `value`; std::domain_error unless 0 < value <= Ks.
  double head_of_conductivity(double value) const;
  /// D = K dh/dtheta at Se; infinite at Se = 1.
  double diffusivity(double saturation) const;

  /// std::invalid_argument unless 0 <= theta_r < theta_s, alpha > 0, n > 1, Ks > 0.
  void validate() const;
};

}  // namespace wetfront::verification::exact
