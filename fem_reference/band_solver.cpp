#include "fem_reference/linear_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wetfront::fem_reference {
namespace {

/// Gaussian elimination of a band with row pivoting. A row holds `width` entries left of the diagonal and
/// 2 `width` right of it (pivoting fills the second half).
class BandSolver : public LinearSolver {
 public:
  explicit BandSolver(int width) : width_(width), stride_(3 * width + 1) {}

  bool solve(const SparseMatrix& matrix, std::vector<double>& b) override {
    const int n = matrix.size();
    band_.assign(static_cast<std::size_t>(n) * stride_, 0.0);
    for (int row = 0; row < n; ++row) {
      for (int k = matrix.row_start[row]; k < matrix.row_start[row + 1]; ++k) {
        at(row, matrix.column[k]) = matrix.value[k];
      }
    }
    for (int k = 0; k < n; ++k) {
      if (!eliminate(k, n, b)) return false;
    }
    for (int row = n - 1; row >= 0; --row) {
      const int last = std::min(n - 1, row + 2 * width_);
      for (int c = row + 1; c <= last; ++c) b[row] -= at(row, c) * b[c];
      b[row] /= at(row, row);
    }
    return true;
  }

 private:
  double& at(int row, int column) { return band_[static_cast<std::size_t>(row) * stride_ + column - row + width_]; }

  bool eliminate(int k, int n, std::vector<double>& b) {
    const int below = std::min(n - 1, k + width_);
    const int right = std::min(n - 1, k + 2 * width_);
    int pivot = k;
    for (int row = k + 1; row <= below; ++row) {
      if (std::abs(at(row, k)) > std::abs(at(pivot, k))) pivot = row;
    }
    if (!(std::abs(at(pivot, k)) > 0)) return false;  // also catches NaN
    if (pivot != k) {
      for (int c = k; c <= right; ++c) std::swap(at(k, c), at(pivot, c));
      std::swap(b[k], b[pivot]);
    }
    for (int row = k + 1; row <= below; ++row) {
      const double factor = at(row, k) / at(k, k);
      if (factor == 0) continue;
      for (int c = k + 1; c <= right; ++c) at(row, c) -= factor * at(k, c);
      b[row] -= factor * b[k];
    }
    return true;
  }

  int width_, stride_;
  std::vector<double> band_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_band_solver(int band_width) {
  return std::make_unique<BandSolver>(band_width);
}

}  // namespace wetfront::fem_reference
