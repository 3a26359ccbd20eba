#pragma once

#include "meshes/field_history.h"
#include "reports/record.h"
#include "verification/compare/histories.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// Pictures of a two-dimensional solution: pore pressure and saturation at the last output time as contours, and the
/// wetting front and the water table at every output time; with the outline of the ground and of its soils. Empty in
/// other dimensions.
std::vector<reports::Figure> plane_figures(const meshes::FieldHistory& history, const std::string& who);

/// Both solutions in one picture each: pressure contours at the last common time, water tables and wetting fronts at
/// every time, the reference solid and the candidate dashed; and contours of their difference on the candidate's mesh.
/// Empty where either mesh is not two-dimensional.
std::vector<reports::Figure> plane_comparison(const Histories& histories);

}  // namespace wetfront::verification
