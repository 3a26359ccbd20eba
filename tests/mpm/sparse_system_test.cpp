// Both linear solvers on the same kind of system.
#include "mpm/seepage/sparse_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {
namespace {

/// Five-point Laplacian with a sideways drift on a square of `side` x `side` unknowns.
std::unique_ptr<SparseSystem> drifting_laplacian(int side) {
  std::vector<std::pair<int, int>> couplings;
  const auto each_neighbour = [side](auto&& visit) {
    for (int row = 0; row < side * side; ++row) {
      if (row % side > 0) visit(row, row - 1, -1.5);
      if (row % side < side - 1) visit(row, row + 1, -0.5);
      if (row >= side) visit(row, row - side, -1.0);
      if (row < side * (side - 1)) visit(row, row + side, -1.0);
    }
  };
  each_neighbour([&](int row, int column, double) { couplings.emplace_back(row, column); });
  auto made = std::make_unique<SparseSystem>(side * side, couplings);
  SparseSystem& system = *made;
  for (int row = 0; row < side * side; ++row) system.values()[static_cast<std::size_t>(system.slot(row, row))] = 4.01;
  each_neighbour([&](int row, int column, double value) {
    system.values()[static_cast<std::size_t>(system.slot(row, column))] = value;
  });
  return made;
}

void expect_solves(int side, bool iterates, double tolerance) {
  const auto made = drifting_laplacian(side);
  SparseSystem& system = *made;
  EXPECT_EQ(system.iterates(), iterates);
  const int n = side * side;
  std::vector<double> b(static_cast<std::size_t>(n)), x(b.size()), check(b.size());
  for (int i = 0; i < n; ++i) b[static_cast<std::size_t>(i)] = std::sin(0.1 * i);
  ASSERT_TRUE(system.solve(b, x));
  double worst = 0;
  for (int row = 0; row < n; ++row) {
    double sum = 4.01 * x[static_cast<std::size_t>(row)];
    if (row % side > 0) sum -= 1.5 * x[static_cast<std::size_t>(row - 1)];
    if (row % side < side - 1) sum -= 0.5 * x[static_cast<std::size_t>(row + 1)];
    if (row >= side) sum -= x[static_cast<std::size_t>(row - side)];
    if (row < side * (side - 1)) sum -= x[static_cast<std::size_t>(row + side)];
    worst = std::max(worst, std::abs(sum - b[static_cast<std::size_t>(row)]));
  }
  EXPECT_LT(worst, tolerance);
}

TEST(SparseSystem, SolvesDirectly) {
  expect_solves(20, false, 1e-12);
}

TEST(SparseSystem, SolvesLargeSystemsIteratively) {
  expect_solves(300, true, 1e-7);
}

TEST(SparseSystem, ReportsASingularMatrix) {
  SparseSystem system(2, {{0, 1}, {1, 0}});
  for (double& value : system.values()) value = 1;
  std::vector<double> b{1, 2}, x(2);
  EXPECT_FALSE(system.solve(b, x));
}

// A diagonal of next to nothing needs another pivot.
TEST(SparseSystem, PivotsWhereTheDiagonalIsTooSmall) {
  SparseSystem system(2, {{0, 1}, {1, 0}});
  for (double& value : system.values()) value = 1;
  system.values()[static_cast<std::size_t>(system.slot(0, 0))] = 1e-20;
  std::vector<double> b{1, 2}, x(2);
  ASSERT_TRUE(system.solve(b, x));
  EXPECT_DOUBLE_EQ(x[0], 1);
  EXPECT_DOUBLE_EQ(x[1], 1);
}

// A run that goes on from a checkpoint begins with a new system.
TEST(SparseSystem, WhatWasSolvedBeforeChangesNoBit) {
  const auto used = drifting_laplacian(20), fresh = drifting_laplacian(20);
  std::vector<double> b(400, 1.0), x(400), y(400);
  // Diagonals that ask for other pivots.
  for (int row = 0; row < 400; ++row)
    used->values()[static_cast<std::size_t>(used->slot(row, row))] = row % 40 == 0 ? 1 : 4;
  used->solve(b, x);
  std::ranges::copy(fresh->values(), used->values().begin());
  ASSERT_TRUE(used->solve(b, x));
  ASSERT_TRUE(fresh->solve(b, y));
  EXPECT_EQ(x, y);
}

TEST(SparseSystem, RowsWithoutCouplingsStandAlone) {
  SparseSystem system(4, {{0, 2}, {2, 0}});
  for (double& value : system.values()) value = 2;
  system.values()[static_cast<std::size_t>(system.slot(0, 2))] = 1;
  system.values()[static_cast<std::size_t>(system.slot(2, 0))] = 0;
  std::vector<double> b{3, 4, 2, 6}, x(4);
  ASSERT_TRUE(system.solve(b, x));
  EXPECT_EQ(x, (std::vector<double>{1, 2, 1, 3}));
}

TEST(SparseSystem, IdentityRowsHoldTheirValue) {
  SparseSystem system(2, {{0, 1}, {1, 0}});
  for (double& value : system.values()) value = 1;
  system.make_identity_row(0);
  std::vector<double> b{3, 5}, x(2);
  ASSERT_TRUE(system.solve(b, x));
  EXPECT_DOUBLE_EQ(x[0], 3);
  EXPECT_DOUBLE_EQ(x[1], 2);
}

}  // namespace
}  // namespace wetfront::mpm
