#include "fem_reference/linear/band_order.h"
#include "fem_reference/linear/linear_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wetfront::fem_reference {
namespace {

/// Gaussian elimination of a band with row pivoting. A row holds `width` entries left of the diagonal and
/// 2 `width` right of it (pivoting fills the second half); last_ tells how far it is filled.
class BandSolver : public LinearSolver {
 public:
  explicit BandSolver(BandOrder order)
      : position_(std::move(order.position)), width_(order.width), stride_(3 * order.width + 1) {}

  bool solve(const SparseMatrix& matrix, std::vector<double>& b) override {
    const int n = matrix.size();
    fill(matrix, b);
    for (int k = 0; k < n; ++k) {
      if (!eliminate(k, n)) return false;
    }
    for (int row = n - 1; row >= 0; --row) {
      const double* entries = &at(row, row);
      double sum = x_[row];
      for (int c = 1; c <= last_[row] - row; ++c) sum -= entries[c] * x_[row + c];
      x_[row] = sum / entries[0];
    }
    for (int i = 0; i < n; ++i) b[i] = x_[position_[i]];
    return true;
  }

 private:
  double& at(int row, int column) { return band_[static_cast<std::size_t>(row) * stride_ + column - row + width_]; }

  void fill(const SparseMatrix& matrix, const std::vector<double>& b) {
    const int n = matrix.size();
    band_.assign(static_cast<std::size_t>(n) * stride_, 0.0);
    x_.resize(n);
    last_.assign(n, 0);
    for (int i = 0; i < n; ++i) {
      const int row = position_[i];
      for (int k = matrix.row_start[i]; k < matrix.row_start[i + 1]; ++k) {
        const int column = position_[matrix.column[k]];
        at(row, column) = matrix.value[k];
        last_[row] = std::max(last_[row], column);
      }
      x_[row] = b[i];
    }
  }

  bool eliminate(int k, int n) {
    const int below = std::min(n - 1, k + width_);
    int pivot = k;
    for (int row = k + 1; row <= below; ++row) {
      if (std::abs(at(row, k)) > std::abs(at(pivot, k))) pivot = row;
    }
    if (!(std::abs(at(pivot, k)) > 0)) return false;  // also catches NaN
    if (pivot != k) {
      const int reach = std::max(last_[k], last_[pivot]);
      for (int c = k; c <= reach; ++c) std::swap(at(k, c), at(pivot, c));
      std::swap(x_[k], x_[pivot]);
      std::swap(last_[k], last_[pivot]);
    }
    const double* __restrict source = &at(k, k);
    const int length = last_[k] - k;
    for (int row = k + 1; row <= below; ++row) {
      double* __restrict entries = &at(row, k);
      const double factor = entries[0] / source[0];
      if (factor == 0) continue;
      for (int c = 1; c <= length; ++c) entries[c] -= factor * source[c];
      x_[row] -= factor * x_[k];
      last_[row] = std::max(last_[row], last_[k]);
    }
    return true;
  }

  std::vector<int> position_;
  int width_, stride_;
  std::vector<double> band_, x_;
  std::vector<int> last_;  ///< [row] -> last column that may be filled
};

}  // namespace

std::unique_ptr<LinearSolver> make_band_solver(BandOrder order) {
  return std::make_unique<BandSolver>(std::move(order));
}

}  // namespace wetfront::fem_reference
