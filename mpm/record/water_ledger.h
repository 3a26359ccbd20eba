#pragma once

#include "mpm/plan/column.h"

namespace wetfront::mpm {

/// Components of the run column "water ledger", provided by whichever effect moves the water. Volumes per metre of
/// thickness in two dimensions [m2], [m3] in three; cumulative but for the two stored ones. See meshes::LedgerRow.
enum LedgerEntry : int {
  ledger_rain_asked,
  ledger_infiltrated,
  ledger_run_off,
  ledger_outflow,
  ledger_stored,
  ledger_stored_points,
  ledger_entries
};

inline ColumnSpec water_ledger_spec() {
  return {"water ledger", "Q", "m3/m", ledger_entries};
}

}  // namespace wetfront::mpm
