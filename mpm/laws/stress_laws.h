#pragma once

#include "mpm/laws/mohr_coulomb.h"

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
        if constexpr (std::is_same_v<Spec, MohrCoulomb>) {
          return body(MohrCoulombLaw(*soil.elastic, spec));
        } else {
          throw CannotPlan("soil '" + soil.name + "' (" + soil.origin + ") has a stress law that is not there yet");
          return body(LinearElastic(*soil.elastic));
        }
      },
      *soil.law);
}

}  // namespace wetfront::mpm
