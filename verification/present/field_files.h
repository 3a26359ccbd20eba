#pragma once

#include "meshes/field_history.h"
#include "reports/record.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// The snapshots of a solver as files for ParaView: one grid per snapshot, and its material points if it has any.
std::vector<reports::FieldFile> field_files(const meshes::FieldHistory& history, const std::string& stem);

}  // namespace wetfront::verification
