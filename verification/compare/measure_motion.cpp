#include "verification/compare/measure_motion.h"

#include "verification/compare/balance.h"
#include "verification/compare/magnitude.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {

using meshes::MotionRow;

double energy_scale(const meshes::FieldHistory& history) {
  double scale = 1e-300;
  for (const MotionRow& row : history.motion)
    for (const double energy : {row.kinetic, row.stress_work, row.load_work, row.resistance,
                                row.potential - history.motion.front().potential})
      scale = std::max(scale, std::abs(energy));
  return scale;
}

double momentum_scale(const meshes::FieldHistory& history) {
  double scale = 1e-300;
  for (const MotionRow& row : history.motion)
    scale = std::max({scale, row.motion, magnitude(row.momentum), magnitude(row.impulse), magnitude(row.reaction)});
  return scale;
}

std::vector<Measurement> measure_motion(const meshes::FieldHistory& whole, double failure) {
  std::vector<Measurement> found;
  const auto own = [&found](const char* quantity, const std::string& description, double error,
                            const std::string& explanation) {
    found.push_back({quantity, description, -1, "", error, {}, explanation});
  };
  // From the last row of that time on: what a hand-over to another scheme changes is told by itself.
  auto begins = std::ranges::upper_bound(whole.ledger, failure, {}, &meshes::LedgerRow::time);
  if (begins != whole.ledger.begin() && begins != whole.ledger.end()) --begins;
  if (const std::vector<meshes::LedgerRow> after(begins, whole.ledger.end()); after.size() > 1)
    own("water_balance", "water balance of the candidate after failure", imbalance(after, {after.back().time}), "");
  if (whole.motion.empty()) return found;
  const double energy = energy_scale(whole), momentum = momentum_scale(whole);
  double energy_drift = 0, momentum_drift = 0;
  for (const MotionRow& row : whole.motion) {
    energy_drift = std::max(energy_drift, std::abs(row.drift) / energy);
    momentum_drift = std::max(momentum_drift, magnitude(row.momentum_drift) / momentum);
  }
  own("energy_balance", "energy that the balance of the moving skeleton lacks", energy_drift,
      fmt::format("of {:.3g} J at most in one form", energy));
  own("momentum_balance", "momentum that weight, loads and sides do not explain", momentum_drift,
      fmt::format("of {:.3g} N s", momentum));
  return found;
}

}  // namespace wetfront::verification
