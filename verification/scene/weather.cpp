#include "verification/scene/weather.h"

#include <algorithm>

namespace wetfront::verification {
namespace {

template <class Entry>
const Entry* on_side(const std::vector<Entry>& entries, const std::string& side) {
  const auto found = std::ranges::find(entries, side, &Entry::side);
  return found == entries.end() ? nullptr : &*found;
}

}  // namespace

const Rain* rain_on(const Scene& scene, const std::string& side) {
  return on_side(scene.rains, side);
}

const Evaporation* evaporation_from(const Scene& scene, const std::string& side) {
  return on_side(scene.evaporations, side);
}

bool under_water(const Scene& scene, const std::string& side) {
  const Boundary* boundary = on_side(scene.boundaries, side);
  return boundary != nullptr && boundary->water == WaterCondition::water_level;
}

}  // namespace wetfront::verification
