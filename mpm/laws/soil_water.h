#pragma once

#include "mpm/laws/relative_permeability.h"

#include <functional>

namespace wetfront::mpm {

/// The hydraulic laws of one soil as value types: what a kernel of `seepage` or of two velocities is compiled for.
template <class Curve, class Permeability>
struct SoilWater {
  Curve curve;
  Permeability permeability;
  double porosity = 0;
  double saturated_mobility = 0;  ///< k/mu [m2/(Pa s)]

  double saturation(double pressure) const { return curve.saturation(-pressure); }
};

/// Calls `body(SoilWater<...>)` with the laws of a soil: the one place where its variants are visited.
/// Throws CannotPlan when the soil lacks a law or when the two laws do not go together.
template <class Body>
void with_soil_water(const Soil& soil, const Water& water, Body&& body) {
  if (!soil.retention || !soil.permeability)
    throw CannotPlan("soil '" + soil.name + "' (" + soil.origin +
                     ") has no retention curve or no permeability law, but the scene has water in it. Add them");
  std::visit(
      [&](const auto& retention, const auto& permeability) {
        if constexpr (requires { make_law(retention), make_law(permeability); }) {
          const auto curve = make_law(retention);
          const auto law = make_law(permeability);
          if constexpr (RelativePermeability<decltype(law), decltype(curve)>) {
            body(SoilWater<std::decay_t<decltype(curve)>, std::decay_t<decltype(law)>>{
                curve, law, soil.porosity, soil.intrinsic_permeability / water.viscosity});
          } else {
            throw CannotPlan("soil '" + soil.name + "' (" + soil.origin +
                             "): Mualem's permeability is a closed form of the van Genuchten curve only, and this "
                             "soil has another retention curve. Use an exponential or constant permeability");
          }
        } else {
          throw CannotPlan("soil '" + soil.name + "' (" + soil.origin + "): this law is not there yet");
        }
      },
      *soil.retention, *soil.permeability);
}

/// Saturation of a soil at a pressure [Pa], type-erased: for figures and gauges, never inside a kernel.
inline std::function<double(double)> saturation_of(const Soil& soil, const Water& water) {
  std::function<double(double)> result;
  with_soil_water(soil, water, [&result](const auto& laws) {
    result = [laws](double pressure) { return laws.saturation(pressure); };
  });
  return result;
}

}  // namespace wetfront::mpm
