#pragma once

#include <vector>

#include "verification/exact/two_layer_modes.h"

namespace wetfront::verification::exact {

/// Srivastava & Yeh 1991 (WRR 27(5):753-762), section 3: two layers of equal alpha above a water table.
/// Layer 1 (lower) fills -L1 < z < 0, layer 2 (upper) 0 < z < L2; z up from the INTERFACE. SI units, fluxes downward
/// positive, K_i = Ks_i exp(alpha psi), theta = theta_r + dtheta exp(alpha psi). psi = base_head at -L1.
///
/// With k = K_i/Ks_i, lengths in 1/alpha, t in dtheta1/(alpha Ks1), u_n, Lambda_n, N_n of TwoLayerMode:
///   k = k_ss(qB) - (qB - qA) exp((L2 - z)/2) sum_n u_n(L2) u_n(z) exp(-Lambda_n t)/(Lambda_n N_n).
/// This self-adjoint form is equivalent to the paper's three cases of roots (both real; one imaginary, beta < 1 or
/// > 1). Valid for fluxes <= min(Ks1, Ks2), base_head <= 0, any ratio of Ks, dtheta and thickness.
struct SrivastavaYehTwoLayer {
  struct Layer {
    double conductivity;  ///< Ks [m/s]
    double theta_r, theta_s;
    double thickness;  ///< m
  };
  double alpha;  ///< 1/m
  Layer lower, upper;
  double flux_before, flux_after;  ///< qA, qB [m/s]
  double base_head = 0;            ///< m
};

/// Throws std::invalid_argument for a problem outside that range; std::domain_error for t < 0, z outside the layers or
/// fewer than 8 digits (t too small for `terms`, or cancellation where the layers are many 1/alpha thick).
class SrivastavaYehTwoLayerSolution {
 public:
  explicit SrivastavaYehTwoLayerSolution(const SrivastavaYehTwoLayer& problem, int terms = 2000);

  double head(double z, double t) const;     ///< psi [m]; continuous across z = 0
  double content(double z, double t) const;  ///< theta; at z = 0 that of the upper layer
  double flux(double z, double t) const;     ///< downward Darcy flux [m/s]; continuous across z = 0
  const std::vector<TwoLayerMode>& modes() const { return modes_; }
  const TwoLayerMedium& medium() const { return medium_; }

 private:
  double relative_conductivity(double z, double t) const;
  double steady(double flux, double z) const;
  void validate(int terms) const;
  void require_inside(double z, double t) const;
  SrivastavaYehTwoLayer p_;
  TwoLayerMedium medium_;
  double time_scale_;  ///< alpha Ks1/dtheta1 [1/s]
  std::vector<TwoLayerMode> modes_;
};

}  // namespace wetfront::verification::exact
