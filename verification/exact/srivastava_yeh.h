#pragma once

#include <vector>

namespace wetfront::verification::exact {

/// Srivastava & Yeh 1991 (WRR 27(5):753-762), one homogeneous layer above a water table: K = Ks exp(alpha psi),
/// theta = theta_r + (theta_s - theta_r) exp(alpha psi). The flux through the surface jumps at t = 0 from
/// `flux_before` (whose steady state is the initial one) to `flux_after`. SI units; z up from the water table.
struct SrivastavaYeh {
  double alpha;         ///< 1/m
  double conductivity;  ///< Ks [m/s]
  double theta_r, theta_s;
  double thickness;                ///< L [m]
  double flux_before, flux_after;  ///< qA, qB, downward positive [m/s]
  double base_head = 0;            ///< psi_0 at z = 0 [m]
};

/// Evaluates the series; roots of tan(lambda L) + 2 lambda = 0 are found once.
class SrivastavaYehSolution {
 public:
  explicit SrivastavaYehSolution(const SrivastavaYeh& problem, int terms = 2000);

  /// Pressure head psi [m] at height z [m], time t >= 0 [s]. Small t needs many terms: the series is cut when
  /// exp(-lambda^2 t) is below 1e-20, so `terms` bounds how early it may be asked (t = 0 is the steady state).
  double head(double z, double t) const;
  /// Downward flux into the water table [m/s].
  double water_table_flux(double t) const;
  /// lambda_k, dimensionless (with z in units of 1/alpha), ascending.
  const std::vector<double>& roots() const { return roots_; }

 private:
  double steady(double flux, double z) const;
  SrivastavaYeh p_;
  double length_, before_, after_,
      time_scale_;  ///< L, qA, qB, alpha Ks/(theta_s - theta_r), dimensionless but the last
  std::vector<double> roots_;
};

}  // namespace wetfront::verification::exact
