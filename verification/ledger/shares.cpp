#include "verification/ledger/shares.h"

#include "verification/compare/outcomes.h"
#include "verification/ledger/delivered_rain.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {

Quantities QuantityReader::operator()(const meshes::FieldHistory& history, const meshes::FieldHistory& cells_of) const {
  Quantities out;
  out.fill(std::numeric_limits<double>::quiet_NaN());
  const auto front = fronts(scene_, history, cells_of);
  if (index_ < front.size()) out[front_position] = front[index_];
  const double area = ledger_area(scene_, history.mesh);
  const auto& rows = history.ledger;
  if (rows.empty() || rows.back().time < time_ * (1 - 1e-9)) return out;
  const std::vector<double> sum = delivered(rows);
  std::size_t after = 0;
  while (after + 1 < rows.size() && rows[after].time < time_) ++after;
  const std::size_t before = after > 0 ? after - 1 : 0;
  const double span = rows[after].time - rows[before].time;
  const double part = span > 0 ? (time_ - rows[before].time) / span : 1;
  out[stored_water] = (rows[before].stored + part * (rows[after].stored - rows[before].stored)) / area;
  out[cumulative_flux] = (sum[before] + part * (sum[after] - sum[before])) / area;
  return out;
}

CauseShares limit_share(const std::string& cause, const Quantities& as_is, const Quantities& finer,
                        const Quantities& finest, const Quantities& scale) {
  CauseShares out;
  out.cause = cause;
  for (int q = 0; q < explained_quantities; ++q) {
    const double first = as_is[q] - finer[q], second = finer[q] - finest[q];
    out.value[q] = first + second;
    out.uncertainty[q] = std::abs(second);
    if (std::abs(first) + std::abs(second) <= 1e-6 * std::abs(scale[q])) continue;  // nothing that could matter
    const double ratio = second / first;
    if (ratio > 0 && ratio < 0.8) {
      const double rest = second * ratio / (1 - ratio);
      out.value[q] += rest;
      out.uncertainty[q] = std::max(0.25 * std::abs(second), std::abs(rest));
    } else if (!(std::abs(ratio) < 0.5)) {
      out.uncertainty[q] = 3 * std::max(std::abs(first), std::abs(second));
      out.converged[q] = false;
    }
  }
  return out;
}

}  // namespace wetfront::verification
