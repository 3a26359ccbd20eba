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
  /// Solves A x = b for the present values; false when the matrix is singular. The same values give the same bits
  /// whatever was solved before. Rows without couplings are divided by their diagonal.
  bool solve(std::span<const double> b, std::span<double> x);
  /// True where a factorisation is so dear that BiCGSTAB with ILUT is tried first.
  bool iterates() const;

  /// Floating-point operations of a factorisation per entry of the matrix up to which it costs no more than ILUT and a
  /// few iterations (.5 us per entry, measured). Slopes in the plane have 70 to 200; cubes of 15 cells have more.
  static constexpr double most_operations_per_entry = 700;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace wetfront::mpm
