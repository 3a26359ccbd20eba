#pragma once

#include "fem_reference/richards_problem.h"

namespace wetfront::fem_reference {

/// A function of pressure head and its derivative with respect to it.
struct ValueAndSlope {
  double value = 0;
  double slope = 0;
};

/// theta(psi), W(psi) and K(psi) of one soil with analytic derivatives. psi [m], negative where unsaturated.
class SoilLaw {
 public:
  explicit SoilLaw(const Soil& soil);

  /// Volumetric water content theta [-] and dtheta/dpsi [1/m]; theta_s for psi >= 0.
  ValueAndSlope water_content(double head) const;
  /// What is conserved: W = theta + sigma max(psi, 0) [-]. One monotone function on the dry and the wet side.
  ValueAndSlope storage(double head) const;
  /// K [m/s] and dK/dpsi [1/s]; Ks for psi >= 0.
  ValueAndSlope conductivity(double head) const;
  /// S = theta / n [-].
  double saturation(double head) const { return water_content(head).value / porosity_; }
  double porosity() const { return porosity_; }

 private:
  Soil soil_;
  double porosity_;
};

}  // namespace wetfront::fem_reference
