#pragma once

#include "reports/record.h"
#include "verification/compare/histories.h"
#include "verification/scene/scene.h"
#include "verification/translate/timeline.h"

#include <string>
#include <vector>

namespace wetfront::verification {

/// What each solver spent, kernel by kernel, with counters.
reports::Table cost_table(const std::string& who, const meshes::FieldHistory& history);

/// When fluxes are told: at the comparison times and the end of the run, or of the timeline if that comes first [s],
/// ascending. The run has a ledger.
std::vector<double> audit_times(const meshes::FieldHistory& history, const Timeline& timeline);

/// The water ledger at the comparison times and at the end of a run, or of the timeline if that comes first [mm].
reports::Table ledger_table(const std::string& who, const meshes::FieldHistory& history, double area,
                            const Timeline& timeline);

/// Rain asked, imposed and run off over each boundary node at the end [litres per metre].
reports::Table node_rain_table(const meshes::FieldHistory& history);

/// The scene in one table: geometry, soil, water, rain, numerics, with units.
reports::Table setup_table(const Scene& scene, const Timeline& timeline);

}  // namespace wetfront::verification
