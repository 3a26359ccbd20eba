#pragma once

#include <vector>

namespace wetfront::verification::exact {

/// Srivastava & Yeh 1991 (WRR 27(5):753-762), one homogeneous layer above a water table: K = Ks exp(alpha psi),
/// theta = theta_r + (theta_s - theta_r) exp(alpha psi). The flux through the surface jumps at t = 0 from
/// `flux_before` (whose steady state is the initial one) to `flux_after`. SI units; z up from the water table.
///
/// With z in units of 1/alpha, t in (theta_s - theta_r)/(alpha Ks), k = K/Ks:  k_t = k_zz + k_z, k(0) =
/// exp(alpha psi_0), k_z + k = q/Ks at L, so
///   k = k_ss(qB) - 4 (qB - qA) exp((L - z)/2 - t/4) sum_j sin(l_j z) sin(l_j L) exp(-l_j^2 t)/(1 + L/2 + 2 l_j^2 L),
///   tan(l L) + 2 l = 0.
/// Valid for fluxes <= Ks and base_head <= 0 (the exponential law ends at psi = 0); a flux may be negative
/// (evaporation) as long as k stays positive. std::invalid_argument otherwise.
struct SrivastavaYeh {
  double alpha;         ///< 1/m
  double conductivity;  ///< Ks [m/s]
  double theta_r, theta_s;
  double thickness;                ///< L [m]
  double flux_before, flux_after;  ///< qA, qB, downward positive [m/s]
  double base_head = 0;            ///< psi_0 at z = 0 [m]
};

/// Evaluates the series; the roots are found once. Everything throws std::domain_error for t < 0, z outside [0, L], or
/// where fewer than 8 digits of K could be given: t too small for `terms`, or cancellation (thick layer, small t).
/// t = 0 is the steady state of `flux_before`.
class SrivastavaYehSolution {
 public:
  explicit SrivastavaYehSolution(const SrivastavaYeh& problem, int terms = 2000);

  /// Pressure head psi [m] at height z [m], time t [s].
  double head(double z, double t) const;
  /// Water content theta(psi(z, t)).
  double content(double z, double t) const;
  /// Downward flux into the water table [m/s].
  double water_table_flux(double t) const;
  /// lambda_k, dimensionless (with z in units of 1/alpha), ascending.
  const std::vector<double>& roots() const { return roots_; }

 private:
  double steady(double flux, double z) const;
  double relative_conductivity(double z, double t) const;
  SrivastavaYeh p_;
  double length_, before_, after_,
      time_scale_;  ///< L, qA, qB, alpha Ks/(theta_s - theta_r), dimensionless but the last
  std::vector<double> roots_;
};

}  // namespace wetfront::verification::exact
