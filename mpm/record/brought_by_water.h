#pragma once

#include "mpm/plan/column.h"

namespace wetfront::mpm {

/// What points gain by becoming heavier where they are: kinetic and potential energy [J], then momentum [N s]. Sums
/// since the stage began, kept by the effect that changes masses, read by the motion ledger.
inline ColumnSpec brought_by_water(int dim) {
  return {"brought by water", "E, p", "J, N s", 1 + dim};
}

}  // namespace wetfront::mpm
