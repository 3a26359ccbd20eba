#pragma once

#include "meshes/field_history.h"
#include "meshes/rain_record.h"

#include <vector>

namespace wetfront::verification {

/// Water that went in since the start by what the soil holds, not by what the boundary code says: change of stored
/// water plus outflow, without what a hand-over between stages changes. One value per row of the ledger.
std::vector<double> delivered(const std::vector<meshes::LedgerRow>& ledger);

/// The same as rain on `area`, at which the cumulative depth is met to 1e-4 of the whole; never negative.
meshes::RainRecord delivered_rain(const std::vector<meshes::LedgerRow>& ledger, double area);

}  // namespace wetfront::verification
