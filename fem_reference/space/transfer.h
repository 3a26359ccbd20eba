#pragma once

#include "fem_reference/stage/flow_operator.h"

namespace wetfront::fem_reference {

/// A state on other degrees of freedom of the same problem.
struct Transferred {
  std::vector<double> head;  ///< [dof of the new mesh], m
  double moved = 0;  ///< water that interpolation gained or lost, summed over patches in size, and put right [m^dim]
  double lost = 0;   ///< of it what could not be put right: stored before less stored after [m^dim]
};

/// Interpolates heads from one refinement of the mesh to another (README, Eq 8): exact where nothing changed. The water
/// that each changed patch gains or loses by that is taken from or given to its own degrees of freedom by shifting
/// their heads alike, but not those of which `fixed` says that their head is given.
Transferred transfer(const FlowOperator& from, std::span<const double> head, const FlowOperator& to,
                     const std::vector<char>& fixed);

}  // namespace wetfront::fem_reference
