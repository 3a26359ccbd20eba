// The reference's own error from its relatives: the estimate on sequences whose error is known.
#include "verification/compare/reference_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < b.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// A number with error c h^order on cells of size 4, 2, 1 and `time` from the tolerance.
ReferenceValues number(double exact, double c, double order, double time = 0) {
  const auto on = [&](double h) { return std::vector<double>{exact + c * std::pow(h, order)}; };
  return {on(2), on(4), on(1), {on(2)[0] - time}};
}

TEST(ReferenceError, SecondOrderIsSeenAndTheErrorCovered) {
  const ReferenceError error = reference_error(number(3, 1e-3, 2), largest_difference);
  EXPECT_EQ(error.convergence, Convergence::monotone);
  EXPECT_NEAR(error.order, 2, 1e-9);
  const double true_error = 4e-3;
  EXPECT_NEAR(error.bound, 1.25 * true_error, 1e-9);
}

TEST(ReferenceError, AFieldIsJudgedAsAWhole) {
  ReferenceValues field{{0, 0, 0}, std::vector<double>{-3, 4, 1}, {0.75, -1, -0.25}, {0, 0, 0}};
  const ReferenceError error = reference_error(field, largest_difference);
  EXPECT_EQ(error.convergence, Convergence::monotone);
  EXPECT_NEAR(error.order, 2, 1e-12);
}

TEST(ReferenceError, ASlowOrderIsNotTrusted) {
  const ReferenceError error = reference_error(number(0, 1e-3, 0.3), largest_difference);
  EXPECT_EQ(error.convergence, Convergence::monotone);
  EXPECT_GE(error.bound, 1e-3 * std::pow(2, 0.3));  // the true error is covered though the order is below 0.5
}

TEST(ReferenceError, ASuspiciouslyHighOrderCountsAsTheFormalOne) {
  const ReferenceError error = reference_error(number(0, 1e-3, 5), largest_difference);
  EXPECT_NEAR(error.bound, 3 * (32 - 1) * 1e-3 / 0.75, 1e-9);
}

TEST(ReferenceError, WhatGoesToAndFroIsBoundedByItsSwing) {
  const ReferenceError error = reference_error({{1.0}, std::vector<double>{2.0}, {1.5}, {1.0}}, largest_difference);
  EXPECT_EQ(error.convergence, Convergence::oscillatory);
  EXPECT_TRUE(std::isnan(error.order));
  EXPECT_EQ(error.bound, 3.0);
}

TEST(ReferenceError, WhatMovesAwayIsDivergent) {
  const ReferenceError error = reference_error({{1.0}, std::vector<double>{0.9}, {1.5}, {1.0}}, largest_difference);
  EXPECT_EQ(error.convergence, Convergence::divergent);
  EXPECT_EQ(error.bound, 1.5);
}

TEST(ReferenceError, ChangesBelowTheTimeErrorSayNothingAboutTheMesh) {
  const ReferenceError error = reference_error(number(1, 1e-6, 2, 1e-3), largest_difference);
  EXPECT_EQ(error.convergence, Convergence::settled);
  EXPECT_NEAR(error.temporal, 2e-3, 1e-12);
}

TEST(ReferenceError, TimeIsPartOfTheBound) {
  const ReferenceError still = reference_error(number(1, 1e-2, 2), largest_difference);
  const ReferenceError moving = reference_error(number(1, 1e-2, 2, 1e-3), largest_difference);
  EXPECT_NEAR(moving.bound - still.bound, 2e-3, 1e-12);
}

TEST(ReferenceError, TwoMeshesGetTheLargestFactor) {
  ReferenceValues values = number(1, 1e-3, 2);
  values.coarser.reset();
  const ReferenceError error = reference_error(values, largest_difference);
  EXPECT_EQ(error.convergence, Convergence::two_meshes);
  EXPECT_NEAR(error.bound, 3 * 4e-3, 1e-12);
}

TEST(ReferenceError, AnEventThatOnlySomeSeeIsUnknown) {
  const double never = std::nan("");
  EXPECT_TRUE(
      std::isnan(reference_error({{never}, std::vector<double>{never}, {never}, {never}}, largest_difference).bound));
  EXPECT_TRUE(std::isinf(reference_error({{5.0}, std::vector<double>{never}, {5.0}, {5.0}}, largest_difference).bound));
}

}  // namespace
}  // namespace wetfront::verification
