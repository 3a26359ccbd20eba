#pragma once

#include "verification/scene/scene.h"
#include "verification/scene/set_value.h"

#include <vector>

namespace wetfront::verification {

/// Settings that multiply the cells per direction; none where that is no mesh of this family (a count that is not
/// whole, or below two). Throws SceneError for a mesh of the user's own.
std::vector<Setting> cells_times(const Scene& scene, double factor);

}  // namespace wetfront::verification
