#pragma once

#include "fem_reference/richards_problem.h"
#include "verification/scene/scene.h"
#include "verification/translate/timeline.h"

namespace wetfront::verification {

/// How finely the reference is computed.
struct Resolution {
  int cells;     ///< as [reference] cells
  int halvings;  ///< of every cell beyond that; -1: cells twice as large (see can_coarsen)
  double tolerance;
};

/// The scene as the finite-element reference sees it (heads, water contents, hydraulic conductivity).
fem_reference::RichardsProblem to_reference(const Scene& scene, const Timeline& timeline, Resolution resolution);

}  // namespace wetfront::verification
