#include "fem_reference/linear_solver.h"

#include <algorithm>
#include <cstdlib>

namespace wetfront::fem_reference {

std::unique_ptr<LinearSolver> make_linear_solver(const SparseMatrix& pattern) {
  int width = 0;
  for (int row = 0; row < pattern.size(); ++row) {
    for (int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k) {
      width = std::max(width, std::abs(pattern.column[k] - row));
    }
  }
  // 3 w^2 flops per row against UMFPACK's several microseconds per row: the band wins well beyond this width
  // in one dimension and is never reached by a real two-dimensional mesh.
  constexpr int widest_band = 8;
  return width <= widest_band ? make_band_solver(width) : make_umfpack_solver();
}

}  // namespace wetfront::fem_reference
