#pragma once

#include "meshes/field_history.h"
#include "reports/record.h"

#include <string>

namespace wetfront::verification {

/// Where points of a body would have left the mesh and were held at its border, a finding without a gate and a line in
/// the log say so: from there on the end of the mesh has a part in the motion. Nothing where none were.
void tell_held_points(reports::Record& record, const std::string& who, const meshes::FieldHistory& history);

}  // namespace wetfront::verification
