#pragma once

#include "fem_reference/linear/linear_solver.h"

#include <vector>

namespace wetfront::fem_reference {

/// An order of the unknowns in which the matrix is a narrow band.
struct BandOrder {
  std::vector<int> position;  ///< [unknown] -> place in the order
  int width = 0;              ///< largest distance of an entry from the diagonal
};

/// Cuthill & McKee 1969 (reversal only matters for profiles): breadth first from an end of the mesh (George & Liu
/// 1979), neighbours of few connections first. A layer of quadrilaterals n nodes thick gets a width of 2 n - 1 at
/// its ends and about n + 1 between them, however long it is. The given order stays where it is as narrow.
BandOrder narrow_band(const SparseMatrix& pattern);

}  // namespace wetfront::fem_reference
