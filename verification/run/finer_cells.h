#pragma once

#include "verification/scene/scene.h"

namespace wetfront::verification {

/// The scene with `factor` times as many cells in each direction, one at least; a mesh of the user's own stays what it
/// is.
Scene with_finer_cells(const Scene& scene, double factor);

}  // namespace wetfront::verification
