#include "verification/compare/side_flux.h"

#include "mpm/problem.h"

#include <algorithm>

namespace wetfront::verification {
namespace {

const std::string& side_of(const meshes::SideLedger& ledger) {
  static const std::string top = "top";
  return ledger.side == mpm::free_surface ? top : ledger.side;
}

bool has(const meshes::FieldHistory& history, const std::string& side) {
  return std::ranges::any_of(history.sides, [&](const auto& ledger) { return side_of(ledger) == side; });
}

}  // namespace

std::vector<std::string> common_sides(const meshes::FieldHistory& candidate, const meshes::FieldHistory& reference) {
  std::vector<std::string> sides;
  if (candidate.mesh.dim != reference.mesh.dim) return sides;  // per area and per width: not alike
  for (const meshes::SideLedger& ledger : reference.sides) {
    const std::string& side = side_of(ledger);
    if (!side.empty() && has(candidate, side) && std::ranges::find(sides, side) == sides.end()) sides.push_back(side);
  }
  return sides;
}

double net_inflow(const meshes::FieldHistory& history, const std::string& side, double time) {
  const auto& rows = history.ledger;
  const auto after = std::ranges::lower_bound(rows, time * (1 - 1e-12), {}, &meshes::LedgerRow::time) - rows.begin();
  const std::size_t last = std::min<std::size_t>(static_cast<std::size_t>(after), rows.size() - 1);
  const std::size_t first = last == 0 ? 0 : last - 1;
  const double span = rows[last].time - rows[first].time;
  const double share = span > 0 ? std::clamp((time - rows[first].time) / span, 0.0, 1.0) : 1;
  double net = 0;
  for (const meshes::SideLedger& ledger : history.sides) {
    if (side_of(ledger) != side) continue;
    const auto at = [&](std::size_t row) {
      const auto entry = [row](const std::vector<double>& column) { return row < column.size() ? column[row] : 0.0; };
      return entry(ledger.asked) - entry(ledger.run_off) - entry(ledger.outflow) - entry(ledger.evaporated);
    };
    net += at(first) + share * (at(last) - at(first));
  }
  return net;
}

}  // namespace wetfront::verification
