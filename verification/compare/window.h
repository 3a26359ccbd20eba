#pragma once

#include "meshes/field_history.h"
#include "mpm/body_record.h"
#include "verification/compare/histories.h"
#include "verification/scene/scene.h"
#include "verification/translate/timeline.h"

#include <vector>

/// Where and until when a body that moves can be compared with Richards' equation, which knows neither motion nor room
/// above the ground.
namespace wetfront::verification {

/// The end of the first stage that ended with failure [s]; infinity where none did.
double failure_time(const mpm::BodyRecord& body);

/// What was recorded until a time.
std::vector<meshes::LedgerRow> cut_at(std::vector<meshes::LedgerRow> ledger, double time);
void cut_at(meshes::FieldHistory& history, double time);
Histories cut_at(const Histories& histories, double time);
/// Stages and comparisons until a time.
Timeline cut_at(const Timeline& timeline, double time);

/// A history on the cells of the ground alone: the empty cells above it and what they hold are left out.
meshes::FieldHistory on_ground(const meshes::FieldHistory& history, const meshes::Mesh& ground);

}  // namespace wetfront::verification
