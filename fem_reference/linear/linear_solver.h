#pragma once

#include "fem_reference/ranks/ranks.h"

#include <memory>
#include <vector>

namespace wetfront::fem_reference {

/// A sparse matrix in compressed rows; columns ascend within a row. On several ranks: the rows of a rank's own
/// unknowns; columns count its own, then its ghosts (Ranks).
struct SparseMatrix {
  std::vector<int> row_start;
  std::vector<int> column;
  std::vector<double> value;

  int size() const { return static_cast<int>(row_start.size()) - 1; }
};

/// What an iterative solver must know beyond the matrix.
struct RowScale {
  std::vector<double> size;  ///< per row: residuals are compared as residual / size
  double tolerance;          ///< of that below which the caller sees no difference
};

/// Solves A x = b for a matrix whose pattern never changes.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  /// Replaces b by x. False when the matrix is singular to working precision, or iterations do not converge.
  virtual bool solve(const SparseMatrix& matrix, std::vector<double>& b) = 0;
};

struct BandOrder;
std::unique_ptr<LinearSolver> make_band_solver(BandOrder order);
std::unique_ptr<LinearSolver> make_umfpack_solver();
/// PETSc: GMRES with incomplete factors, and with algebraic multigrid where those need many iterations. On one rank
/// UMFPACK does what it cannot.
std::unique_ptr<LinearSolver> make_krylov_solver(const SparseMatrix& pattern, RowScale scale, const Ranks& ranks);

/// A band solver where an order of the unknowns makes the pattern a narrow band (columns, layers), UMFPACK for a few
/// hundred unknowns, else Krylov; the README has the measurements.
std::unique_ptr<LinearSolver> make_linear_solver(const SparseMatrix& pattern, RowScale scale, const Ranks& ranks);

}  // namespace wetfront::fem_reference
