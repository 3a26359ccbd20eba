#include "verification/compare/events.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {
constexpr double never = std::numeric_limits<double>::quiet_NaN();
}

double ponding_time(const std::vector<meshes::LedgerRow>& ledger) {
  if (ledger.empty()) return never;
  const double noise = 1e-9 * ledger.back().rain_asked;
  for (std::size_t i = 1; i < ledger.size(); ++i) {
    if (ledger[i].run_off <= noise) continue;
    // The step in which run-off starts holds only part of it; the next one shows its rate.
    const std::size_t next = std::min(i + 1, ledger.size() - 1);
    const std::size_t from = next == i ? i - 1 : i;
    const double rate = (ledger[next].run_off - ledger[from].run_off) / (ledger[next].time - ledger[from].time);
    return std::max(ledger[i - 1].time, ledger[i].time - ledger[i].run_off / rate);
  }
  return never;
}

double crossing_time(const meshes::Gauge& gauge, double threshold) {
  for (std::size_t i = 1; i < gauge.time.size(); ++i) {
    const double before = gauge.pressure[i - 1], after = gauge.pressure[i];
    if (before > threshold || after <= threshold) continue;
    return gauge.time[i - 1] + (threshold - before) / (after - before) * (gauge.time[i] - gauge.time[i - 1]);
  }
  return never;
}

double rise_rate(const meshes::Gauge& gauge, double unit_weight) {
  const double duration = crossing_time(gauge, risen_pressure) - crossing_time(gauge, arrival_pressure);
  return (risen_pressure - arrival_pressure) / unit_weight / duration;
}

double ledger_at(const std::vector<meshes::LedgerRow>& ledger, double meshes::LedgerRow::*column, double time) {
  if (ledger.empty()) return never;
  const auto after = std::find_if(ledger.begin(), ledger.end(), [&](const auto& row) { return row.time >= time; });
  if (after == ledger.end()) return ledger.back().*column;
  if (after == ledger.begin()) return (*after).*column;
  const auto before = std::prev(after);
  const double fraction = (time - before->time) / (after->time - before->time);
  return (1 - fraction) * ((*before).*column) + fraction * ((*after).*column);
}

}  // namespace wetfront::verification
