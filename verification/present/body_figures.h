#pragma once

#include "meshes/field_history.h"
#include "reports/record.h"
#include "verification/present/figure_frame.h"

#include <span>
#include <vector>

namespace wetfront::verification {

/// A deforming body in the plane: its outline at every one of the times, which ascend, and its points at the last.
/// Empty where the skeleton is rigid, and in other dimensions.
std::vector<reports::Figure> body_figures(const meshes::Mesh& mesh, std::span<const meshes::Snapshot* const> times,
                                          const FigureHeading& heading);
/// The same at every output time.
std::vector<reports::Figure> body_figures(const meshes::FieldHistory& history);

}  // namespace wetfront::verification
