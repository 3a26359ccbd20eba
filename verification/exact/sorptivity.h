#pragma once

#include <functional>
#include <vector>

#include "verification/exact/van_genuchten.h"

namespace wetfront::verification::exact {

/// Horizontal absorption theta_t = (D theta_x)_x into a half-space at theta_i whose face is held at theta_0 = theta_i +
/// dtheta: theta depends on x/sqrt(t) alone, and what has entered is S sqrt(t). With Theta = (theta - theta_i)/dtheta
/// and the flux-concentration relation F(Theta) (Philip 1973; McWhorter & Sunada 1990, WRR 26:399)
///   F(Theta) = 1 - N(Theta)/N(0),  N(Theta) = integral_Theta^1 (T - Theta) D(T)/F(T) dT,
///   S^2 = 2 dtheta^2 N(0),  x = (S/dtheta) F'(Theta) sqrt(t),
/// iterated from F = Theta to rest. Exact for any D(Theta) > 0 on (0, 1) that is integrable at 1 (D(0) = 0 allowed).
class Sorptivity {
 public:
  /// `diffusivity` maps Theta in (0, 1) to D [length^2/time]. std::invalid_argument if D is not positive and finite
  /// there or content_range <= 0; std::domain_error if the fixed point does not come to rest in 500 rounds.
  Sorptivity(const std::function<double(double)>& diffusivity, double content_range);
  /// Absorption from effective saturation `initial` to `face`, 0 < initial < face < 1 (D is infinite at 1).
  Sorptivity(const VanGenuchten& soil, double initial, double face);

  double value() const { return sorptivity_; }   ///< S [length/time^1/2], to about 1e-9 relative
  double parlange() const { return parlange_; }  ///< Parlange 1975: S^2 = integral (theta_0 + theta - 2 theta_i) D
  /// x/sqrt(t) where the normalised content is Theta in (0, 1). std::domain_error outside.
  double position(double theta) const;
  /// F(Theta).
  double flux_concentration(double theta) const;
  int rounds() const { return rounds_; }

 private:
  void iterate();
  double interpolate(const std::vector<double>& panel_values, double at_zero, double theta) const;
  double range_, sorptivity_ = 0, parlange_ = 0;
  int rounds_ = 0;
  std::vector<double> edges_;                  ///< panel ends, graded towards both 0 and 1
  std::vector<double> diffusivity_;            ///< at the nodes of all panels
  std::vector<double> concentration_, slope_;  ///< F and F' at the nodes
};

}  // namespace wetfront::verification::exact
