#pragma once

#include "mpm/plan/stage_plan.h"

namespace wetfront::mpm {

/// What passed each water boundary of the problem, cumulative [m^dim], in the run column "side ledger": component
/// condition * side_entries + entry. See meshes::SideLedger.
enum SideEntry : int { side_asked, side_run_off, side_outflow, side_evaporated, side_demanded, side_entries };

constexpr int side_component(int condition, SideEntry entry) {
  return condition * side_entries + entry;
}

template <int dim>
ColumnSpec side_ledger_spec(const StagePlan<dim>& plan, const std::string& suffix, Lifetime lifetime) {
  return {"side ledger" + suffix, "Q_side", "m3/m", side_entries * static_cast<int>(plan.problem.water_boundary.size()),
          lifetime};
}

/// Writes the column into FieldHistory::sides, one entry per row of the ledger. Periodic sides pass no water of the
/// body and have no entry.
template <int dim>
void record_sides(StagePlan<dim>& plan, const Column& totals);

}  // namespace wetfront::mpm
