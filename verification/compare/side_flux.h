#pragma once

#include "meshes/field_history.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// Names of the sides with a ledger in both histories, in the order of the second, each once. (The free surface that
/// the candidate finds inside cells is the side "top".)
std::vector<std::string> common_sides(const meshes::FieldHistory& candidate, const meshes::FieldHistory& reference);

/// Water that came in through a side until a time, less what left [m3/m2 in one dimension, m3/m in two, m3 in three],
/// over all conditions on it; linear between the rows of the ledger. In two dimensions only comparable on bodies of the
/// same width.
double net_inflow(const meshes::FieldHistory& history, const std::string& side, double time);

}  // namespace wetfront::verification
