#pragma once

#include "verification/exact/srivastava_yeh.h"

namespace wetfront::verification::exact {

/// Srivastava & Yeh's layer laid on an infinite slope (the transform of Iverson 2000, WRR 36:1897, for Gardner's soil).
/// Nothing changes along the slope, so mass balance along the normal n (up from the water table) reads
///   theta_t = d/dn [ K (psi_n + cos beta) ],   K (psi_n + cos beta) = I cos beta at the surface,
/// with I the rain per HORIZONTAL area. That is the level problem with z = alpha n cos beta,
/// t = alpha Ks t* cos^2 beta/(theta_s - theta_r), L = alpha H cos beta, q = I/Ks. Water also runs down the slope at
/// K sin beta, which the balance along n does not see.
struct SrivastavaYehSlope {
  double alpha;         ///< 1/m
  double conductivity;  ///< Ks [m/s]
  double theta_r, theta_s;
  double thickness;                ///< H [m], measured along the normal
  double angle;                    ///< beta [rad], in [0, pi/2)
  double rain_before, rain_after;  ///< I per horizontal area [m/s], downward positive
  double base_head = 0;            ///< psi at n = 0 [m]
};

/// Errors as SrivastavaYehSolution; std::invalid_argument also for an angle outside [0, pi/2).
class SrivastavaYehSlopeSolution {
 public:
  explicit SrivastavaYehSlopeSolution(const SrivastavaYehSlope& problem, int terms = 2000);

  /// Pressure head psi [m] at n [m] along the normal, time t [s].
  double head(double n, double t) const { return cosine_ * level_.head(n, t); }
  double content(double n, double t) const { return level_.content(n, t); }
  /// Flux into the water table along the inward normal, per area of slope [m/s] (its limit is I cos beta).
  double water_table_flux(double t) const { return level_.water_table_flux(t); }

 private:
  double cosine_;
  SrivastavaYehSolution level_;
};

}  // namespace wetfront::verification::exact
