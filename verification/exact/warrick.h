#pragma once

#include <vector>

namespace wetfront::verification::exact {

/// Warrick 1975 (Soil Sci. 120:79-84): infiltration into a deep column of Gardner's soil (K = Ks exp(alpha psi),
/// theta linear in K) under an arbitrary surface flux in time, here a piecewise constant one. z DOWN. With lengths in
/// 1/alpha, t in dtheta/(alpha Ks), k = K/Ks: k_t = k_zz - k_z, k - k_z = q(t)/Ks at z = 0. A step of 1 in q gives
///   P(z, t) = 1/2 erfc((z-t)/(2 sqrt t)) + sqrt(t/pi) exp(-(z-t)^2/(4t)) - 1/2 (1+z+t) e^z erfc((z+t)/(2 sqrt t))
/// (van Genuchten & Alves 1982, A2), and steps add up: k = q_0/Ks + sum_j (q_j - q_{j-1})/Ks P(z, t - t_j).
struct Warrick {
  struct Step {
    double start;  ///< s, ascending, the first >= 0
    double flux;   ///< from then on [m/s], downward positive; negative: evaporation
  };
  double alpha;         ///< 1/m
  double conductivity;  ///< Ks [m/s]
  double theta_r, theta_s;
  double initial_flux;  ///< q_0 in (0, Ks]: the column starts uniform with K = q_0
  std::vector<Step> steps;
};

/// std::invalid_argument for parameters outside the ranges above or a flux above Ks; std::domain_error for z < 0, t < 0
/// and where evaporation has drawn K to 0 or below (the surface would dry out: the flux can no longer be held).
class WarrickSolution {
 public:
  explicit WarrickSolution(const Warrick& problem);

  double head(double z, double t) const;     ///< psi [m]
  double content(double z, double t) const;  ///< theta
  /// P(z, t) above, dimensionless: exact to about 1e-15 absolute (e^z erfc(.) through erfcx).
  static double step_response(double z, double t);

 private:
  double relative_conductivity(double z, double t) const;
  Warrick p_;
};

}  // namespace wetfront::verification::exact
