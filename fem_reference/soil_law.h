#pragma once

#include "fem_reference/monotone_cubic.h"
#include "fem_reference/soil_curves.h"

namespace wetfront::fem_reference {

/// theta(psi), W(psi) and K(psi) of one soil with analytic derivatives. psi [m], negative where unsaturated.
class SoilLaw {
 public:
  explicit SoilLaw(const Soil& soil);

  /// Volumetric water content theta [-] and dtheta/dpsi [1/m]; theta_s for psi >= -air_entry().
  ValueAndSlope water_content(double head) const;
  /// What is conserved: W = theta + sigma max(psi + air_entry, 0) [-]. One monotone function on the dry and the wet
  /// side.
  ValueAndSlope storage(double head) const;
  /// K [m/s] and dK/dpsi [1/s]; Ks where saturated.
  ValueAndSlope conductivity(double head) const;
  /// S = theta / n [-].
  double saturation(double head) const { return water_content(head).value / porosity_; }
  double porosity() const { return porosity_; }
  /// Suction up to which the soil stays full [m].
  double air_entry() const { return air_entry_; }

 private:
  ValueAndSlope relative_conductivity(double head) const;

  Soil soil_;
  double theta_r_ = 0, theta_s_ = 0, porosity_ = 0;
  double air_entry_ = 0;           ///< of the content [m]
  double conductivity_entry_ = 0;  ///< K = Ks for psi >= -this [m]
  double content_scale_ = 1;       ///< (theta_s - theta_r) / Se(-air_entry) of a law with a cut-off
  double conductivity_scale_ = 1;  ///< Ks / Kr(-air_entry) of a law with a cut-off [m/s]
  MonotoneCubic content_table_, log_conductivity_table_;
};

}  // namespace wetfront::fem_reference
