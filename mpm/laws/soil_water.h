#pragma once

#include "mpm/laws/tabulated.h"

#include <functional>

namespace wetfront::mpm {

/// The hydraulic laws of one soil as value types: what a kernel of `seepage` or of two velocities is compiled for.
template <class Curve, class Permeability>
struct SoilWater {
  Curve curve;
  Permeability permeability;
  double porosity = 0;            ///< -
  double saturated_mobility = 0;  ///< k/mu [m2/(Pa s)]

  double saturation(double pressure) const { return curve.saturation(-pressure); }
};

using TabulatedSoilWater = SoilWater<TabulatedCurve, TabulatedPermeability>;

/// Throws CannotPlan when the soil lacks a law that water needs.
inline void check_laws(const Soil& soil) {
  if (!soil.retention || !soil.permeability)
    throw CannotPlan("soil '" + soil.name + "' (" + soil.origin +
                     ") has no retention curve or no permeability law, but the scene has water in it. Add them");
}

/// Any soil as tables. Throws CannotPlan when the soil lacks a law or when the two laws do not go together.
inline TabulatedSoilWater tabulated_soil_water(const Soil& soil, const Water& water) {
  check_laws(soil);
  return {TabulatedCurve(sampled_retention(*soil.retention)), TabulatedPermeability(sampled_permeability(soil)),
          soil.porosity, soil.intrinsic_permeability / water.viscosity};
}

/// Whether kernels are compiled for the curve itself. The others come as tables.
inline bool has_closed_form(const RetentionSpec& spec) {
  const auto* van_genuchten = std::get_if<VanGenuchtenRetention>(&spec);
  return std::holds_alternative<ExponentialRetention>(spec) ||
         (van_genuchten != nullptr && !(van_genuchten->cut_off > 0));
}

/// Calls `body(SoilWater<...>)` with the laws of a soil: the one place where its variants are visited. The common pairs
/// are closed forms, the rare ones tables of one type. Throws CannotPlan as tabulated_soil_water does.
template <class Body>
void with_soil_water(const Soil& soil, const Water& water, Body&& body) {
  check_laws(soil);
  if (!has_closed_form(*soil.retention)) return body(tabulated_soil_water(soil, water));
  std::visit(
      [&](const auto& retention, const auto& permeability) {
        if constexpr (requires { make_law(retention), make_law(permeability); }) {
          const auto curve = make_law(retention);
          const auto law = make_law(permeability);
          if constexpr (RelativePermeability<decltype(law), decltype(curve)>) {
            return body(SoilWater<std::decay_t<decltype(curve)>, std::decay_t<decltype(law)>>{
                curve, law, soil.porosity, soil.intrinsic_permeability / water.viscosity});
          }
        }
        body(tabulated_soil_water(soil, water));
      },
      *soil.retention, *soil.permeability);
}

/// Saturation of a soil at a pressure [Pa], type-erased: for figures and gauges, never inside a kernel.
inline std::function<double(double)> saturation_of(const Soil& soil, const Water& water) {
  return [laws = tabulated_soil_water(soil, water)](double pressure) { return laws.saturation(pressure); };
}

}  // namespace wetfront::mpm
