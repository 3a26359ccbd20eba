#pragma once

#include "verification/scene/scene.h"

#include <string>

namespace wetfront::verification {

/// What falls on a side and what evaporates from it; nullptr where the scene says nothing.
const Rain* rain_on(const Scene& scene, const std::string& side);
const Evaporation* evaporation_from(const Scene& scene, const std::string& side);
/// A water level stands in front of the side: rain on what is under water is none of the soil's business.
bool under_water(const Scene& scene, const std::string& side);

}  // namespace wetfront::verification
