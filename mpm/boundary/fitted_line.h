#pragma once

#include "mpm/grid/polygon.h"

namespace wetfront::mpm {

/// The line that holds `area` of the cell and whose soil has its centroid where the points have theirs, along the line;
/// at most 30 degrees from `guess`, a unit vector out of the soil.
HalfPlane fitted_line(const Polygon& cell, double area, const Vector<2>& centroid, const Vector<2>& guess);

}  // namespace wetfront::mpm
