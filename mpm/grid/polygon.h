#pragma once

#include "mpm/grid/stencil.h"

#include <array>

namespace wetfront::mpm {

/// A convex polygon in the plane, counter-clockwise; small and without memory of its own.
struct Polygon {
  static constexpr int most = 16;
  std::array<Vector<2>, most> corner{};
  int size = 0;

  void add(const Vector<2>& x) { corner[static_cast<std::size_t>(size++)] = x; }
  const Vector<2>& operator[](int i) const { return corner[static_cast<std::size_t>(i)]; }
};

/// The half-plane normal.x <= offset.
struct HalfPlane {
  Vector<2> normal{};
  double offset = 0;

  double beyond(const Vector<2>& x) const { return normal[0] * x[0] + normal[1] * x[1] - offset; }
};

Polygon clipped(const Polygon& polygon, const HalfPlane& half);

struct AreaAndCentroid {
  double area = 0;  ///< > 0 when counter-clockwise [m2]
  Vector<2> centroid{};
};
/// Exact; the centroid of a polygon without area is its first corner.
AreaAndCentroid measure(const Polygon& polygon);

/// The half-plane with a given unit normal that holds `area` of a polygon, 0 < area < all of it. Error in the area: a
/// few roundings of the polygon's.
HalfPlane half_plane_of_area(const Polygon& polygon, const Vector<2>& normal, double area);

}  // namespace wetfront::mpm
