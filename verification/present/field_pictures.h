#pragma once

#include "reports/record.h"
#include "verification/compare/histories.h"
#include "verification/scene/scene.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// Pore pressure and degree of saturation at the last comparison time as the MPM has them, as the reference has them,
/// and their difference, on the MPM's mesh; its nodes outside the reference's are left out. Empty but in two
/// dimensions.
std::vector<reports::FieldPicture> field_pictures(const Histories& histories);

/// The same of one solution, and how far its nodes moved where they did.
std::vector<reports::FieldPicture> field_pictures(const meshes::FieldHistory& history, const std::string& who);

/// Displacement of the nodes, by its amount; empty where nothing moved.
std::vector<reports::FieldPicture> displacement_picture(const meshes::FieldHistory& history, const std::string& who);

/// kPa per metre of water; 0 where there is none, and without gravity, where pressure is no head.
double pressure_per_head(const Scene& scene);

}  // namespace wetfront::verification
