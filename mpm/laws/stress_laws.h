#pragma once

#include "mpm/laws/hencky.h"
#include "mpm/laws/modified_cam_clay.h"
#include "mpm/laws/mohr_coulomb.h"
#include "mpm/laws/neo_hookean.h"
#include "mpm/laws/softening_mohr_coulomb.h"
#include "mpm/laws/suction_mohr_coulomb.h"

#include <type_traits>

namespace wetfront::mpm {

/// Calls `body(law)` with the stress law of a soil: the one place where its variants are visited. Throws CannotPlan
/// when the soil has no `elastic`.
template <class Body>
decltype(auto) with_stress_law(const Soil& soil, Body&& body) {
  if (!soil.elastic)
    throw CannotPlan("soil '" + soil.name + "' (" + soil.origin +
                     ") has no elastic constants, but its skeleton deforms. Add `elastic`");
  if (!soil.law) return body(LinearElastic(*soil.elastic));
  return std::visit(
      [&](const auto& spec) -> decltype(auto) {
        using Spec = std::decay_t<decltype(spec)>;
        const Elastic& elastic = *soil.elastic;
        if constexpr (std::is_same_v<Spec, MohrCoulomb>) return body(MohrCoulombLaw(elastic, spec));
        if constexpr (std::is_same_v<Spec, SofteningMohrCoulomb>) return body(SofteningMohrCoulombLaw(elastic, spec));
        if constexpr (std::is_same_v<Spec, SuctionMohrCoulomb>) return body(SuctionMohrCoulombLaw(elastic, spec));
        if constexpr (std::is_same_v<Spec, ModifiedCamClay>) return body(ModifiedCamClayLaw(elastic, spec));
        if constexpr (std::is_same_v<Spec, NeoHookean>) return body(NeoHookeanLaw(elastic));
        if constexpr (std::is_same_v<Spec, Hencky>) return body(HenckyLaw(elastic));
      },
      *soil.law);
}

}  // namespace wetfront::mpm
