#pragma once

#include "verification/suites/mechanics/incline_block.h"

#include <vector>

namespace wetfront::verification {

/// The block of `incline_block.h` by other means, to tell what material points do from what the body does: a Lagrangian
/// mesh of bilinear squares (2 x 2 Gauss points, small strains, lumped mass, explicit), whose lowest nodes meet the
/// base with Coulomb's law, with their own gap. It shares nothing with mpm/. Undamped; begins with the same K_0 stress.
/// Places are relative to the beginning.
std::vector<BlockState> lagrangian_block_path(const InclineBlock& block, const std::vector<double>& times);

}  // namespace wetfront::verification
