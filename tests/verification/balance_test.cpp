#include "verification/compare/balance.h"

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

}  // namespace
}  // namespace wetfront::verification
