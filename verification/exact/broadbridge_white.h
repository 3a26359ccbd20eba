#pragma once

namespace wetfront::verification::exact {

/// Broadbridge & White 1988 (WRR 24:145-154): constant flux R into a deep uniform soil with
///   D = C (C - 1)/(C - Theta)^2,  K = (C - 1) Theta^2/(C - Theta),  C > 1, Theta(z, 0) = 0,
/// everything dimensionless: z DOWN in lambda_s, t in lambda_s dtheta/Ks, R = flux/Ks, Theta = (theta -
/// theta_n)/dtheta, psi in lambda_s. Theta_t = (D Theta_z)_z - K_z, K - D Theta_z = R at z = 0.
///
/// The reciprocal transformation dX = (C - Theta) dz + (flux) dt and Hopf-Cole make it linear. With b = C(C - 1),
/// X = Y + R t, y = Y/sqrt(b), r = sqrt(R^2/(4b) + c),
///   G_c = e^{ct}/2 [e^{-yr} erfc(y/(2 sqrt t) - r sqrt t) + e^{yr} erfc(y/(2 sqrt t) + r sqrt t)],
///   phi = 1 + e^{-RY/(2b)} (G_R - G_0);  z = (X - ln phi)/C,  Theta = C - C/(1 - phi_X/phi),  Y >= 0.
/// (Own derivation, residual in README.md.) For R > 1 the surface saturates at time_to_ponding(); the solution ends
/// there. Accuracy: Theta to about 1e-13 absolute; head() therefore refuses Theta < 1e-6.
class BroadbridgeWhite {
 public:
  /// Throws std::invalid_argument unless C > 1 and R > 0.
  BroadbridgeWhite(double c, double flux);

  /// Theta at depth z >= 0, time t >= 0. std::domain_error for t beyond ponding or R t > 600 (e^{R t} overflows).
  double saturation(double z, double t) const;
  double surface_saturation(double t) const;
  /// Time at which Theta(0, t) = 1; infinity for R <= 1.
  double time_to_ponding() const { return ponding_; }
  /// psi(z, t) <= 0; std::domain_error where Theta < 1e-6 (too dry to be known).
  double head(double z, double t) const;

  double diffusivity(double saturation) const;
  double conductivity(double saturation) const;
  /// psi = 1 - 1/Theta - (1/C) ln[(C - Theta)/((C - 1) Theta)], from D = K dpsi/dTheta and psi(1) = 0.
  double head_of(double saturation) const;

 private:
  struct Potential {
    double phi, slope;  ///< phi and phi_Y
  };
  Potential potential(double y_distance, double t) const;
  double saturation_at(double y_distance, double t) const;
  void require_time(double t) const;
  double c_, flux_, b_, ponding_;
};

}  // namespace wetfront::verification::exact
