#pragma once

#include "meshes/field_history.h"
#include "reports/record.h"
#include "verification/translate/timeline.h"

namespace wetfront::verification {

/// The water that passed each side by the comparison times and the end of run or timeline [litres per square metre of
/// ground, per metre of width or in all, as the mesh leaves out two, one or no dimensions]. No rows where the solver
/// keeps no such ledger.
reports::Table side_table(const std::string& who, const meshes::FieldHistory& history, const Timeline& timeline);

}  // namespace wetfront::verification
