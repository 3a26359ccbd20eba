#pragma once

namespace wetfront::verification::exact {

/// Green & Ampt 1911 (J. Agric. Sci. 4:1): a sharp front under a ponded (depth 0) surface,
///   dF/dt = K (1 + S/F),  S = front suction * content deficit  =>  F - S ln(1 + F/S) = K t,
///   F = -S [1 + W_-1(-exp(-1 - K t/S))].
/// Under rain r (Mein & Larson 1973, WRR 9:384) all of it enters until F_p = S K/(r - K) at t_p = F_p/r; then the same
/// equation goes on from F_p. On a slope of angle beta (Chen & Young 2006, WRR 42 W07422) everything is per area of
/// slope, F along the normal: K -> K cos beta, S -> S/cos beta, and rain per horizontal area enters as r cos beta.
/// F [m], t [s], all SI.
struct GreenAmpt {
  double conductivity;   ///< K [m/s]
  double front_suction;  ///< psi_f > 0 [m]
  double deficit;        ///< dtheta in (0, 1]
  double angle = 0;      ///< beta [rad], in [0, pi/2)
};

/// std::invalid_argument for parameters outside the ranges above; std::domain_error for t < 0 (and t = 0 in capacity).
class GreenAmptSolution {
 public:
  explicit GreenAmptSolution(const GreenAmpt& problem);

  double ponded_infiltration(double t) const;  ///< F(t) from a surface ponded since t = 0
  double capacity(double infiltrated) const;   ///< f = K (1 + S/F), F > 0
  /// t_p under rain per horizontal area [m/s]; infinity when the rain never exceeds K.
  double time_to_ponding(double rain) const;
  double rain_infiltration(double rain, double t) const;  ///< F(t) under that rain

 private:
  double k_, s_, cosine_;  ///< K and S with the slope in them
};

}  // namespace wetfront::verification::exact
