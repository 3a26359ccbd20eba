#pragma once

#include "mpm/body_record.h"
#include "verification/compare/measure.h"
#include "verification/scene/scene.h"

#include <vector>

namespace wetfront::verification {

/// Of the events that the scene's stages are to end with (failure, rest), the share that did not come in their time:
/// none or one measurement. A run that gave up or was stopped has missed what it did not reach.
std::vector<Measurement> missed_events(const Scene& scene, const mpm::BodyRecord& body);

}  // namespace wetfront::verification
