#pragma once

#include "fem_reference/richards_problem.h"

namespace wetfront::verification {

/// The slope of the seed paper's flume (Moriwaki et al. 2004; benchmarks.md 5.1): a base of 6 m at 0, 6 m at 10, 10 m
/// at 30 and 1 m at 0 degrees, 1.2 m of sand over it measured vertically, rain of 3e-5 m/s on top for 9267 s, seepage
/// face at the toe (left), no flux through base and right. At the start hydrostatic over a water table at the toe's
/// base, suction at most 10 kPa. 230 x 12 cells are the 3003 unknowns of the paper's size.
fem_reference::RichardsProblem flume_slope(int cells_along, int cells_over);

}  // namespace wetfront::verification
