#pragma once

#include "meshes/field_history.h"

/// Moments and rates read off a solver's ledger and gauges. Every one is NaN where it did not happen.
namespace wetfront::verification {

/// Start of run-off [s]: the rate of the first full step with run-off, carried back to zero run-off.
double ponding_time(const std::vector<meshes::LedgerRow>& ledger);

/// First time the gauge's pressure rises through `threshold` [Pa], between steps by linear interpolation.
/// A gauge that starts above it has no arrival.
double crossing_time(const meshes::Gauge& gauge, double threshold);

/// Secant slope of the gauge's pressure head between 0.2 and 4.9 kPa [m/s] (benchmarks section 4).
double rise_rate(const meshes::Gauge& gauge, double unit_weight);

/// Value of a ledger column at a time, linear between steps.
double ledger_at(const std::vector<meshes::LedgerRow>& ledger, double meshes::LedgerRow::*column, double time);

constexpr double arrival_pressure = 200;  ///< Pa: first rise is p > 0.2 kPa, never a change of p
constexpr double risen_pressure = 4900;   ///< Pa

}  // namespace wetfront::verification
