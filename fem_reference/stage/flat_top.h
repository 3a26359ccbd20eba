#pragma once

#include "fem_reference/soil/soil_law.h"

#include <vector>

namespace wetfront::fem_reference {

/// Near saturation W is flat: within `gap` [m] of the head at which a soil is full, W drops by less than the Newton
/// tolerance.
struct FlatTop {
  double full;
  double gap;
};

/// Per soil: the head at which it fills and how far below that theta has dropped by `drop` [m], by bisection.
std::vector<FlatTop> flat_tops(const std::vector<SoilLaw>& laws, double drop);

}  // namespace wetfront::fem_reference
