#pragma once

#include "meshes/field_history.h"

#include <vector>

/// Water balances read off a ledger, from the change of stored water: independent of the code that imposed the rain.
namespace wetfront::verification {

/// Largest |stored - stored_0 - infiltrated + outflow| over the run, relative to the rain asked for until the end
/// (or to the water exchanged, where it does not rain). Each stage is counted from its own start, so that what a
/// hand-over changes is not charged to the scheme.
double imbalance(const std::vector<meshes::LedgerRow>& ledger, const std::vector<double>& stage_ends);

enum class Sum { nodal, points };

/// |delivered - (asked - run-off)| / asked of one stage, where delivered = change of stored water + outflow;
/// NaN where no rain was asked for.
double undelivered(const std::vector<meshes::LedgerRow>& ledger, double from, double until, Sum sum);

/// Change of stored water across the hand-over at `time` (two rows at the same time), relative to the water stored;
/// 0 where there is none.
double hand_over_jump(const std::vector<meshes::LedgerRow>& ledger, double time);

}  // namespace wetfront::verification
