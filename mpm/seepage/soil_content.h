#pragma once

#include "mpm/laws/soil_water.h"

#include <algorithm>

namespace wetfront::mpm {

/// Water per pore volume of a soil at pore pressure p: S(-p), plus linear storage S_max beta (p + entry) while the
/// pores are full, that is for p > -entry (cut-off or entry of the curve, else 0). One continuous, non-decreasing
/// function. beta = 1/K_l, or what the soil says of its own storage; 0 for water that cannot be compressed.
class SoilContent {
 public:
  SoilContent(const Soil& soil, const TabulatedCurve& curve, double bulk_modulus)
      : curve_(curve),
        entry_(curve.saturated_until()),
        effective_(soil.bishop == Bishop::effective_saturation),
        stored_per_pressure_(soil.storage ? *soil.storage / soil.porosity : curve.s_max() / bulk_modulus) {}

  ValueAndSlope at(double p) const {
    const double above = p + entry_;
    // At the kink itself as above it: there the curve's slope is none, and a full node would hold no water of its own.
    if (above >= 0) return {curve_.s_max() + stored_per_pressure_ * above, stored_per_pressure_};
    const ValueAndSlope saturation = curve_.saturation_at(-p);
    return {saturation.value, -saturation.slope};
  }
  /// chi p and d(chi p)/dp, what the water bears of the total stress; chi as the soil says.
  ValueAndSlope pore_stress(double p) const {
    const ValueAndSlope chi = effective_ ? curve_.effective_at(-p) : curve_.saturation_at(-p);
    return {chi.value * p, chi.value - p * chi.slope};
  }
  /// The pressure at which at(p) is this; beyond what the curve can tell its driest.
  double pressure_at(double content) const {
    if (content > curve_.s_max()) return (content - curve_.s_max()) / stored_per_pressure_ - entry_;
    const double effective = (content - curve_.s_min()) / (curve_.s_max() - curve_.s_min());
    return -curve_.suction_at(std::clamp(effective, 1e-6, 1.0));
  }
  double saturation(double p) const { return curve_.saturation(-p); }
  bool compressible() const { return stored_per_pressure_ > 0; }
  const TabulatedCurve& curve() const { return curve_; }

 private:
  TabulatedCurve curve_;
  double entry_;
  bool effective_;
  double stored_per_pressure_;
};

}  // namespace wetfront::mpm
