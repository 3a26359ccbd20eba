#pragma once

#include "mpm/grid/grid.h"

#include <functional>
#include <vector>

namespace wetfront::mpm {

/// A nodal field at the cell centres, one value per cell, exact for quadratic fields:
///   p_c = mean over the corners of p_i + 1/2 g_i . (x_c - x_i),
/// g_i = mean of the centre gradients of the cells of one soil around the corner (gradient averaging after
/// Zienkiewicz and Zhu 1987). The mean of the corners alone misses p_c by h2/8 p'' at a wetting front, more than the
/// scheme's own error there (README, section 8). The value is kept within those of the cell's corners, so that it
/// makes no new extremum. Only cells with soil have a gradient: nodal values above the ground mean
/// nothing. `soil_of` tells the soil that a cell holds, or most of it; -1: none.
template <int dim>
std::vector<double> cell_values(const Grid<dim>& grid, const double* nodal,
                                const std::function<int(std::size_t)>& soil_of);

}  // namespace wetfront::mpm
