#pragma once

#include "meshes/field_history.h"
#include "mpm/body_record.h"
#include "reports/record.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// The snapshots of a solver as files for ParaView: one grid per snapshot, and its material points if it has any. Those
/// of a body that moves go on through its pictures, whose points have their displacement.
std::vector<reports::FieldFile> field_files(const meshes::FieldHistory& history, const std::string& stem,
                                            const mpm::BodyRecord& body = {});

}  // namespace wetfront::verification
