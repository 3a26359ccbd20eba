#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace wetfront::mpm {

/// A sparse unsymmetric linear system whose pattern never changes: couplings are named once, values are written through
/// slots, the symbolic factorisation is done once.
class SparseSystem {
 public:
  /// `couplings` are (row, column) pairs, repetitions allowed; the diagonal is always there.
  SparseSystem(int rows, const std::vector<std::pair<int, int>>& couplings);
  ~SparseSystem();

  /// Index into `values()` of a coupling that was named.
  int slot(int row, int column) const;
  std::span<double> values();
  /// Makes the row `x = right-hand side`.
  void make_identity_row(int row);
  /// Solves A x = b for the present values; false when the matrix is singular.
  bool solve(std::span<const double> b, std::span<double> x);
  /// "sparse LU", or "BiCGSTAB + ILUT" for more unknowns than `direct_limit`.
  std::string method() const;

  /// Above this many unknowns the fill of a direct solver costs more than some tens of iterations.
  static constexpr int direct_limit = 3000;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace wetfront::mpm
