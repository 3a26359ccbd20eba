#include "verification/scene/scene.h"

#include <algorithm>

namespace wetfront::verification {

bool deforms(const Scene& scene) {
  return std::ranges::any_of(scene.soils, [](const Soil& soil) { return soil.elastic.has_value(); });
}

bool has_events(const Scene& scene) {
  return std::ranges::any_of(scene.stages,
                             [](const Stage& stage) { return stage.event.kind != StageEvent::Kind::none; });
}

}  // namespace wetfront::verification
