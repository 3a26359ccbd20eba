#include "mpm/grid/polygon.h"

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {

Polygon clipped(const Polygon& polygon, const HalfPlane& half) {
  Polygon out;
  for (int i = 0; i < polygon.size; ++i) {
    const Vector<2>&a = polygon[i], &b = polygon[(i + 1) % polygon.size];
    const double da = half.beyond(a), db = half.beyond(b);
    if (da <= 0) out.add(a);
    if ((da < 0 && db > 0) || (da > 0 && db < 0)) {
      const double t = da / (da - db);
      out.add({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
    }
  }
  return out;
}

AreaAndCentroid measure(const Polygon& polygon) {
  AreaAndCentroid out;
  if (polygon.size == 0) return out;
  // Relative to the first corner, so that a small polygon far from the origin loses no digits.
  const Vector<2>& origin = polygon[0];
  Vector<2> moment{};
  for (int i = 1; i + 1 < polygon.size; ++i) {
    const Vector<2> a{polygon[i][0] - origin[0], polygon[i][1] - origin[1]},
        b{polygon[i + 1][0] - origin[0], polygon[i + 1][1] - origin[1]};
    const double triangle = 0.5 * (a[0] * b[1] - a[1] * b[0]);
    out.area += triangle;
    for (int k = 0; k < 2; ++k) moment[k] += triangle * (a[k] + b[k]) / 3;
  }
  for (int k = 0; k < 2; ++k) out.centroid[k] = origin[k] + (out.area > 0 ? moment[k] / out.area : 0);
  return out;
}

HalfPlane half_plane_of_area(const Polygon& polygon, const Vector<2>& normal, double area) {
  double low = HalfPlane{normal, 0}.beyond(polygon[0]), high = low;
  for (int i = 1; i < polygon.size; ++i) {
    const double along = HalfPlane{normal, 0}.beyond(polygon[i]);
    low = std::min(low, along);
    high = std::max(high, along);
  }
  const double span = high - low;
  const double whole = measure(polygon).area;
  double below = -area, above = whole - area;
  double offset = low + span * std::clamp(area / whole, 0.01, 0.99);
  // Regula falsi (Illinois) in the offset: the area is a continuous, increasing, piecewise quadratic function of it.
  int side = 0;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double excess = measure(clipped(polygon, {normal, offset})).area - area;
    if (std::abs(excess) <= 1e-15 * whole || high - low <= 1e-16 * span) break;
    if (excess > 0) {
      high = offset;
      above = excess;
      if (side == 1) below /= 2;
      side = 1;
    } else {
      low = offset;
      below = excess;
      if (side == -1) above /= 2;
      side = -1;
    }
    const double next = low + (high - low) * below / (below - above);
    if (next == offset) break;
    offset = next;
  }
  return {normal, offset};
}

}  // namespace wetfront::mpm
