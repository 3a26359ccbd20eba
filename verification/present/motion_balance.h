#pragma once

#include "meshes/field_history.h"
#include "reports/record.h"
#include "verification/translate/timeline.h"

#include <vector>

namespace wetfront::verification {

/// Energy and momentum of a skeleton that moves dynamically, at the comparison times and at the end; for a history with
/// `motion`.
reports::Table motion_table(const meshes::FieldHistory& history, const Timeline& timeline);

/// Kinetic energy and the works over time; empty where no skeleton moves dynamically.
std::vector<reports::Figure> motion_figures(const meshes::FieldHistory& history);

}  // namespace wetfront::verification
