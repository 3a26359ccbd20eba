#include "fem_reference/linear/linear_solver.h"
#include "fem_reference/linear/band_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace wetfront::fem_reference {
namespace {

struct Grid {
  int along, over;
  int size() const { return along * over; }
};

/// Nine-point stencil: `mass` on the diagonal, an even exchange with all neighbours and a drift that makes it
/// unsymmetric. Unknowns count along the grid's long way, so that the given band is wide.
SparseMatrix stencil(const Grid& grid, double mass, double drift) {
  SparseMatrix matrix;
  matrix.row_start.push_back(0);
  for (int j = 0; j < grid.over; ++j) {
    for (int i = 0; i < grid.along; ++i) {
      const std::size_t first = matrix.value.size();
      std::size_t diagonal = 0;
      double sum = 0;
      for (int y = std::max(0, j - 1); y <= std::min(grid.over - 1, j + 1); ++y) {
        for (int x = std::max(0, i - 1); x <= std::min(grid.along - 1, i + 1); ++x) {
          const bool self = x == i && y == j;
          if (self) diagonal = matrix.value.size();
          const double value = self ? 0 : -1 - drift * (y - j);
          matrix.column.push_back(y * grid.along + x);
          matrix.value.push_back(value);
          sum += value;
        }
      }
      matrix.value[first + (diagonal - first)] = mass - sum;
      matrix.row_start.push_back(static_cast<int>(matrix.value.size()));
    }
  }
  return matrix;
}

void hold(SparseMatrix& matrix, int row) {
  for (int k = matrix.row_start[row]; k < matrix.row_start[row + 1]; ++k) {
    matrix.value[k] = matrix.column[k] == row ? 1 : 0;
  }
}

std::vector<double> wanted(int n) {
  std::vector<double> x(n);
  for (int i = 0; i < n; ++i) x[i] = std::sin(0.37 * i) + 2;
  return x;
}

std::vector<double> product(const SparseMatrix& matrix, const std::vector<double>& x) {
  std::vector<double> b(x.size(), 0.0);
  for (int i = 0; i < matrix.size(); ++i) {
    for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k) b[i] += matrix.value[k] * x[matrix.column[k]];
  }
  return b;
}

double error_of(LinearSolver& solver, const SparseMatrix& matrix) {
  const std::vector<double> exact = wanted(matrix.size());
  std::vector<double> x = product(matrix, exact);
  EXPECT_TRUE(solver.solve(matrix, x));
  double worst = 0;
  for (std::size_t i = 0; i < x.size(); ++i) worst = std::max(worst, std::abs(x[i] - exact[i]));
  return worst;
}

RowScale scale_of(const SparseMatrix& matrix) {
  return {std::vector<double>(matrix.size(), 1.0), 1e-12};
}

TEST(BandOrder, MakesALongLayerNarrow) {
  const SparseMatrix layer = stencil({200, 7}, 1, 0);
  EXPECT_LE(narrow_band(layer).width, 13);  // 2 * 7 - 1 at the ends; as counted here 201
}

TEST(BandOrder, NumbersPartsThatDoNotTouchOneAfterTheOther) {
  SparseMatrix parts = stencil({6, 1}, 1, 0);
  hold(parts, 3);
  parts.column[parts.row_start[3]] = parts.column[parts.row_start[3] + 2] = 3;  // the pattern is cut in two
  std::vector<int> position = narrow_band(parts).position;
  std::sort(position.begin(), position.end());
  for (int i = 0; i < 6; ++i) EXPECT_EQ(position[i], i);
}

TEST(LinearSolvers, AgreeWithTheKnownSolution) {
  const SparseMatrix matrix = stencil({60, 9}, 0.5, 0.8);
  EXPECT_LT(error_of(*make_band_solver(narrow_band(matrix)), matrix), 1e-12);
  EXPECT_LT(error_of(*make_umfpack_solver(), matrix), 1e-12);
  // relative 1e-6 of the residual, times a condition of about 40
  EXPECT_LT(error_of(*make_krylov_solver(matrix, scale_of(matrix), {}), matrix), 1e-4);
}

TEST(LinearSolvers, PivotWhereTheDiagonalVanishes) {
  SparseMatrix matrix = stencil({30, 1}, 0.1, 0);
  matrix.value[0] = 0;  // the first to be eliminated: the given order is narrow and stays
  EXPECT_LT(error_of(*make_band_solver(narrow_band(matrix)), matrix), 1e-10);
}

TEST(LinearSolvers, SayThatAMatrixIsSingular) {
  SparseMatrix matrix = stencil({10, 3}, 1, 0);
  for (int k = matrix.row_start[14]; k < matrix.row_start[15]; ++k) matrix.value[k] = 0;
  std::vector<double> b(matrix.size(), 1.0);
  EXPECT_FALSE(make_band_solver(narrow_band(matrix))->solve(matrix, b));
}

TEST(KrylovSolver, HoldsGivenRowsExactlyWhateverTheirSize) {
  SparseMatrix matrix = stencil({40, 20}, 0.1, 0.2);
  for (int row : {0, 5, 399, 799}) hold(matrix, row);
  const auto solver = make_krylov_solver(matrix, {std::vector<double>(matrix.size(), 1e-6), 1e-9}, {});
  std::vector<double> b(matrix.size(), 1e-9);
  b[5] = -100;
  ASSERT_TRUE(solver->solve(matrix, b));
  EXPECT_EQ(b[5], -100);
  const std::vector<double> back = product(matrix, b);
  // one held head of 100 excites the others: their residuals fall by 1e-6 of that
  EXPECT_NEAR(back[6], 1e-9, 1e-3);
  EXPECT_NEAR(back[100], 1e-9, 1e-4);
}

TEST(KrylovSolver, CallsMultigridWhereIncompleteFactorsCrawl) {
  SparseMatrix matrix = stencil({150, 150}, 1e-9, 0);  // a Laplacian: incomplete factors need hundreds of iterations
  hold(matrix, 0);
  const auto solver = make_krylov_solver(matrix, scale_of(matrix), {});
  const std::vector<double> exact = wanted(matrix.size());
  const std::vector<double> b = product(matrix, exact);
  std::vector<double> x = b;
  ASSERT_TRUE(solver->solve(matrix, x));
  const std::vector<double> back = product(matrix, x);
  double residual = 0, size = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    residual += std::pow(back[i] - b[i], 2);
    size += b[i] * b[i];
  }
  EXPECT_LT(std::sqrt(residual / size), 1e-6);
}

}  // namespace
}  // namespace wetfront::fem_reference
