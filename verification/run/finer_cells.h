#pragma once

#include "verification/scene/scene.h"

namespace wetfront::verification {

/// The scene with `factor` times as many cells in each direction; a mesh of the user's own stays what it is.
Scene with_finer_cells(const Scene& scene, int factor);

}  // namespace wetfront::verification
