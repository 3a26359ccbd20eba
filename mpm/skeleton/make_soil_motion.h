#pragma once

#include "mpm/laws/stress_laws.h"
#include "mpm/skeleton/soil_motion.h"

/// Instantiated in one file per dimension and shape: seven laws in lanes take a compiler a while.
namespace wetfront::mpm {

template <int dim, class Shape>
std::unique_ptr<SoilMotion<dim>> make_soil_motion(const Soil& soil, const Shape& shape,
                                                  const SoilMotionSetting<dim>& setting) {
  return with_stress_law(soil, [&](const auto& law) -> std::unique_ptr<SoilMotion<dim>> {
    using Law = std::decay_t<decltype(law)>;
    return std::make_unique<LawMotion<dim, Shape, Law>>(shape, setting, law);
  });
}

}  // namespace wetfront::mpm
