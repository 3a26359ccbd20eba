#include "verification/compare/balance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

using Row = meshes::LedgerRow;

/// Rows of the stage (from, until]; the first is its start: after a hand-over two rows share that time, the later
/// counts.
std::pair<std::size_t, std::size_t> rows_of_stage(const std::vector<Row>& ledger, double from, double until) {
  const double slack = 1e-9 * std::max(1.0, until);
  std::size_t first = 0, last = 0;
  for (std::size_t i = 0; i < ledger.size(); ++i) {
    if (ledger[i].time <= from + slack) first = i;
    if (ledger[i].time <= until + slack) last = i;
  }
  // The hand-over row at the end of the stage belongs to the next one.
  while (last > first + 1 && ledger[last].time == ledger[last - 1].time) --last;
  return {first, last};
}

double stored(const Row& row, Sum sum) {
  return sum == Sum::nodal ? row.stored : row.stored_points;
}

double exchanged(const Row& from, const Row& until) {
  return std::abs(until.infiltrated - from.infiltrated) + std::abs(until.outflow - from.outflow);
}

}  // namespace

double imbalance(const std::vector<Row>& ledger, const std::vector<double>& stage_ends) {
  double worst = 0, start = ledger.front().time;
  const double total = std::max(ledger.back().rain_asked, exchanged(ledger.front(), ledger.back()));
  const double scale = total > 0 ? total : ledger.front().stored;
  for (const double end : stage_ends) {
    const auto [first, last] = rows_of_stage(ledger, start, end);
    const Row& zero = ledger[first];
    for (std::size_t i = first; i <= last; ++i) {
      const double error = (ledger[i].stored - zero.stored) - (ledger[i].infiltrated - zero.infiltrated) +
                           (ledger[i].outflow - zero.outflow);
      if (!std::isfinite(error)) return std::numeric_limits<double>::infinity();
      worst = std::max(worst, std::abs(error) / scale);
    }
    start = end;
  }
  return worst;
}

double undelivered(const std::vector<Row>& ledger, double from, double until, Sum sum) {
  const auto [first, last] = rows_of_stage(ledger, from, until);
  const Row &a = ledger[first], &b = ledger[last];
  const double asked = b.rain_asked - a.rain_asked;
  if (!(asked > 0)) return std::numeric_limits<double>::quiet_NaN();
  const double delivered = stored(b, sum) - stored(a, sum) + b.outflow - a.outflow;
  return std::abs(delivered - (asked - (b.run_off - a.run_off))) / asked;
}

double hand_over_jump(const std::vector<Row>& ledger, double time) {
  const double slack = 1e-9 * std::max(1.0, time);
  for (std::size_t i = 1; i < ledger.size(); ++i)
    if (ledger[i].time == ledger[i - 1].time && std::abs(ledger[i].time - time) <= slack)
      return std::abs(ledger[i].stored - ledger[i - 1].stored) / ledger[i - 1].stored;
  return 0;
}

}  // namespace wetfront::verification
