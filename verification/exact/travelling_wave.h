#pragma once

#include "verification/exact/van_genuchten.h"

namespace wetfront::verification::exact {

/// The wetting front that infiltration at a constant rate tends to (Philip 1957; Vanderborght et al. 2005, VZJ 4:206,
/// case M2.1): theta(z, t) = theta(eta), eta = z - v t, z DOWN, between head_behind (eta -> -infinity) and head_ahead.
/// Mass balance gives v = (K_b - K_a)/(theta_b - theta_a) and, from K (1 - dh/deta) - K_a = v (theta - theta_a),
///   dh/deta = [(K - K_a) - v (theta - theta_a)]/K,
/// integrated by quadrature over ln(-h). eta = 0 where (theta - theta_a)/(theta_b - theta_a) = 1/2. Units of the soil.
class TravellingWave {
 public:
  /// head_behind from the rate: K(head_behind) = rate, 0 < rate <= Ks. At rate = Ks the soil behind is saturated.
  /// std::invalid_argument unless head_ahead < head_behind <= 0.
  static TravellingWave from_rate(const VanGenuchten& soil, double rate, double head_ahead);
  TravellingWave(const VanGenuchten& soil, double head_behind, double head_ahead);

  double speed() const { return speed_; }         ///< v, downward positive
  double head_behind() const { return behind_; }  ///< K(head_behind) = rate
  double content_behind() const { return content_behind_; }
  /// eta of the place where the head is h, head_ahead < h < head_behind (strictly: the ends lie at infinity), to 1e-10.
  double offset(double head) const;
  /// eta where (theta - theta_a)/(theta_b - theta_a) = fraction, in (0, 1).
  double offset_at_fraction(double fraction) const;
  /// The head at eta, within the front. std::domain_error where h is within 1e-7 relative (of the range of theta) of
  /// either end: the wave is flat there and eta no longer fixes h.
  double head(double offset) const;
  double head_at_fraction(double fraction) const;

 private:
  VanGenuchten soil_;
  double behind_, ahead_, content_behind_, content_ahead_, conductivity_ahead_, speed_, middle_;
};

}  // namespace wetfront::verification::exact
