#pragma once

#include "meshes/field_history.h"
#include "reports/record.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// Pictures of a two-dimensional solution: pore pressure and saturation at the last output time as contours, and the
/// wetting front and the water table at every output time; with the outline of the ground and of its soils. Empty in
/// other dimensions.
std::vector<reports::Figure> plane_figures(const meshes::FieldHistory& history, const std::string& who);

}  // namespace wetfront::verification
