#pragma once

#include <memory>
#include <vector>

namespace wetfront::fem_reference {

/// A sparse matrix in compressed rows; columns ascend within a row.
struct SparseMatrix {
  std::vector<int> row_start;
  std::vector<int> column;
  std::vector<double> value;

  int size() const { return static_cast<int>(row_start.size()) - 1; }
};

/// Solves A x = b for a matrix whose pattern never changes.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  /// Replaces b by x. False when the matrix is singular to working precision.
  virtual bool solve(const SparseMatrix& matrix, std::vector<double>& b) = 0;
};

std::unique_ptr<LinearSolver> make_band_solver(int band_width);
std::unique_ptr<LinearSolver> make_umfpack_solver();

/// A band solver where the pattern is a narrow band (columns and thin strips), else UMFPACK.
std::unique_ptr<LinearSolver> make_linear_solver(const SparseMatrix& pattern);

}  // namespace wetfront::fem_reference
