#pragma once

#include "meshes/field_history.h"
#include "reports/record.h"

#include <vector>

namespace wetfront::verification {

/// A deforming body in the plane: its outline at every output time and its points at the last. Empty where the skeleton
/// is rigid, and in other dimensions.
std::vector<reports::Figure> body_figures(const meshes::FieldHistory& history);

}  // namespace wetfront::verification
