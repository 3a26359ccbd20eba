#include "verification/compare/balance.h"
#include "verification/compare/measure_motion.h"
#include "verification/compare/side_flux.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wetfront::verification {
namespace {

meshes::LedgerRow row(double time, double asked, double infiltrated, double outflow, double stored) {
  meshes::LedgerRow out;
  out.time = time;
  out.rain_asked = asked;
  out.infiltrated = infiltrated;
  out.run_off = asked - infiltrated;
  out.outflow = outflow;
  out.stored = out.stored_points = stored;
  return out;
}

TEST(Balance, ClosesWhenStorageFollowsTheFluxes) {
  const std::vector<meshes::LedgerRow> ledger = {row(0, 0, 0, 0, 5), row(1, 2, 2, 0.5, 6.5), row(2, 4, 3, 1, 7)};
  EXPECT_NEAR(imbalance(ledger, {2}), 0, 1e-15);
  EXPECT_NEAR(undelivered(ledger, 0, 2, Sum::nodal), 0, 1e-15);
}

TEST(Balance, LostWaterShowsWhateverTheBoundaryCodeClaims) {
  const std::vector<meshes::LedgerRow> ledger = {row(0, 0, 0, 0, 5), row(2, 4, 4, 0, 8)};
  EXPECT_NEAR(imbalance(ledger, {2}), 0.25, 1e-15);
  EXPECT_NEAR(undelivered(ledger, 0, 2, Sum::nodal), 0.25, 1e-15);
}

TEST(Balance, ANegativeErrorCountsLikeAPositiveOne) {
  const std::vector<meshes::LedgerRow> ledger = {row(0, 0, 0, 0, 5), row(2, 4, 4, 0, 10)};
  EXPECT_NEAR(imbalance(ledger, {2}), 0.25, 1e-15);
  EXPECT_NEAR(undelivered(ledger, 0, 2, Sum::points), 0.25, 1e-15);
}

TEST(Balance, WaterThatIsNotANumberIsNoBalance) {
  const std::vector<meshes::LedgerRow> ledger = {row(0, 0, 0, 0, 5), row(2, 4, 4, 0, std::nan(""))};
  EXPECT_TRUE(std::isinf(imbalance(ledger, {2})));
}

TEST(Balance, AHandOverIsNotChargedToTheStageAfterIt) {
  const std::vector<meshes::LedgerRow> ledger = {row(0, 0, 0, 0, 5), row(1, 1, 1, 0, 6), row(1, 1, 1, 0, 6.1),
                                                 row(2, 2, 2, 0, 7.1)};
  EXPECT_NEAR(imbalance(ledger, {1, 2}), 0, 1e-15);
  EXPECT_NEAR(undelivered(ledger, 1, 2, Sum::nodal), 0, 1e-15);
  EXPECT_NEAR(hand_over_jump(ledger, 1), 0.1 / 6, 1e-15);
}

/// Two conditions on one side count together, water in counts up, times lie between rows; the surface found in cells is
/// "top".
TEST(SideFlux, AddsWhatPassedASideWhateverItsConditions) {
  meshes::FieldHistory history, other;
  history.mesh.dim = other.mesh.dim = 2;
  history.ledger = {row(0, 0, 0, 0, 5), row(2, 4, 4, 0, 9)};
  history.sides = {{"free surface", "rain", {0, 4}, {0, 1}, {0, 0.5}, {0, 0.25}, {0, 1}},
                   {"left", "water level", {0, 0}, {0, 0}, {0, -3}, {0, 0}, {0, 0}},
                   {"left", "rain", {0, 1}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
                   {"", "source", {0, 0}, {0, 0}, {0, -7}, {0, 0}, {0, 0}}};
  other.sides = {{"left", "water level", {}, {}, {}, {}, {}},
                 {"top", "rain", {}, {}, {}, {}, {}},
                 {"left", "rain", {}, {}, {}, {}, {}},
                 {"right", "head", {}, {}, {}, {}, {}}};
  EXPECT_EQ(common_sides(history, other), (std::vector<std::string>{"left", "top"}));
  EXPECT_DOUBLE_EQ(net_inflow(history, "top", 2), 4 - 1 - 0.5 - 0.25);
  EXPECT_DOUBLE_EQ(net_inflow(history, "left", 2), 4);
  EXPECT_DOUBLE_EQ(net_inflow(history, "left", 0.5), 1);
  other.mesh.dim = 1;
  EXPECT_TRUE(common_sides(history, other).empty());
}

/// What the run itself must hold: drift is told as a share of the largest form, and water after failure by itself.
TEST(Motion, LostEnergyMomentumAndWaterShow) {
  meshes::FieldHistory history;
  history.ledger = {row(0, 0, 0, 0, 5), row(1, 2, 2, 0, 6), row(1, 2, 2, 0, 6), row(2, 4, 4, 0, 7.9)};
  EXPECT_TRUE(measure_motion(history, std::numeric_limits<double>::infinity()).empty());
  meshes::MotionRow begin, end;
  begin.potential = 500;
  end.potential = 100;
  end.kinetic = 80;
  end.stress_work = 300;
  end.drift = -20;
  end.impulse = {0, -50, 0};
  end.reaction = {0, 49, 0};
  end.momentum_drift = {0, 1, 0};
  history.motion = {begin, end};
  const auto found = measure_motion(history, 1);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].quantity, "water_balance");
  EXPECT_NEAR(found[0].error, 0.1 / 4, 1e-15);  // of the rain; what was lost before failure is not charged here
  EXPECT_EQ(found[1].quantity, "energy_balance");
  EXPECT_NEAR(found[1].error, 20.0 / 400, 1e-15);
  EXPECT_EQ(found[2].quantity, "momentum_balance");
  EXPECT_NEAR(found[2].error, 1.0 / 50, 1e-15);
}

}  // namespace
}  // namespace wetfront::verification
