#pragma once

#include "fem_reference/soil/conductivity_integral.h"
#include "fem_reference/soil/monotone_cubic.h"
#include "fem_reference/soil/skeleton_storage.h"
#include "fem_reference/soil/soil_curves.h"

#include <optional>

namespace wetfront::fem_reference {

/// theta(psi), W(psi) and K(psi) of one soil with analytic derivatives. psi [m], negative where unsaturated.
class SoilLaw {
 public:
  /// `unit_weight` of the water [Pa/m] turns heads into the pressures that an elastic skeleton feels.
  explicit SoilLaw(const Soil& soil, double unit_weight = 9810);

  /// Volumetric water content theta [-] and dtheta/dpsi [1/m]; theta_s for psi >= -air_entry().
  ValueAndSlope water_content(double head) const;
  /// What is conserved: W = theta + sigma max(psi + air_entry, 0) [-], and what an elastic skeleton takes up. One
  /// monotone function on the dry and the wet side.
  ValueAndSlope storage(double head) const;
  /// K [m/s] and dK/dpsi [1/s]; Ks where saturated.
  ValueAndSlope conductivity(double head) const;
  /// Integral of K over the head [m2/s] and K.
  ValueAndSlope conductivity_integral(double head) const { return conductivity_integral_(head); }
  /// S = theta / n [-].
  double saturation(double head) const { return water_content(head).value / porosity_; }
  double porosity() const { return porosity_; }
  /// Suction up to which the soil stays full [m].
  double air_entry() const { return air_entry_; }
  /// Below this head an elastic skeleton would make W fall with rising head [m]; -infinity for a rigid one.
  double skeleton_limit() const;

 private:
  ValueAndSlope relative_conductivity(double head) const;
  ValueAndSlope conductivity_near_saturation(double head) const;
  /// S (chi + p dchi/dp) / E_oed per m of head [1/m].
  double skeleton_rate(double head, double unit_weight) const;

  Soil soil_;
  double theta_r_ = 0, theta_s_ = 0, porosity_ = 0;
  double air_entry_ = 0;           ///< of the content [m]
  double conductivity_entry_ = 0;  ///< K = Ks for psi >= -this [m]
  double smooth_top_ = 0;          ///< K is a cubic for psi in [-this, 0] [m]
  ValueAndSlope at_top_;           ///< K and its slope there
  double content_scale_ = 1;       ///< (theta_s - theta_r) / Se(-air_entry) of a law with a cut-off
  double conductivity_scale_ = 1;  ///< Ks / Kr(-air_entry) of a law with a cut-off [m/s]
  MonotoneCubic content_table_, log_conductivity_table_;
  std::optional<SkeletonStorage> skeleton_;
  ConductivityIntegral conductivity_integral_;
};

}  // namespace wetfront::fem_reference
