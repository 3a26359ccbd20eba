#include "fem_reference/linear/linear_solver.h"

#include "fem_reference/linear/band_order.h"

#include <utility>

namespace wetfront::fem_reference {

std::unique_ptr<LinearSolver> make_linear_solver(const SparseMatrix& pattern, RowScale scale, const Ranks& ranks) {
  if (ranks.count() > 1) return make_krylov_solver(pattern, std::move(scale), ranks);
  // Measured (README): up to a width of 40 (a layer of 20 nodes) the band is cheapest at any size; beyond it
  // UMFPACK loses to iterations already at 700 unknowns, by 17 in three dimensions.
  constexpr int widest_band = 40, direct_size = 500;
  BandOrder order = narrow_band(pattern);
  if (order.width <= widest_band) return make_band_solver(std::move(order));
  if (pattern.size() <= direct_size) return make_umfpack_solver();
  return make_krylov_solver(pattern, std::move(scale), ranks);
}

}  // namespace wetfront::fem_reference
