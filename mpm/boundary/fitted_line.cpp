#include "mpm/boundary/fitted_line.h"

#include <cmath>
#include <numbers>

namespace wetfront::mpm {

namespace {

constexpr double largest_correction = std::numbers::pi / 6;

Vector<2> turned(const Vector<2>& v, double angle) {
  return {std::cos(angle) * v[0] - std::sin(angle) * v[1], std::sin(angle) * v[0] + std::cos(angle) * v[1]};
}

}  // namespace

/// Turning a chord of length L about its middle moves the centroid along it by L^3/(12 area) per radian, and only along
/// it: the misfit along the chord is zero where the whole misfit is least.
HalfPlane fitted_line(const Polygon& cell, double area, const Vector<2>& centroid, const Vector<2>& guess) {
  const auto misfit = [&](double angle) {
    const Vector<2> normal = turned(guess, angle);
    const Vector<2> found = measure(clipped(cell, half_plane_of_area(cell, normal, area))).centroid;
    return -normal[1] * (found[0] - centroid[0]) + normal[0] * (found[1] - centroid[1]);
  };
  double low = -largest_correction, high = largest_correction;
  double at_low = misfit(low), at_high = misfit(high);
  double angle = std::abs(at_low) < std::abs(at_high) ? low : high;
  if (at_low * at_high < 0) {
    int side = 0;
    for (int iteration = 0; iteration < 60 && high - low > 1e-15; ++iteration) {
      const double next = (low * at_high - high * at_low) / (at_high - at_low);
      if (next == angle) break;
      angle = next;
      const double value = misfit(angle);
      if (value == 0) break;
      if ((value < 0) == (at_low < 0)) {
        low = angle;
        at_low = value;
        if (side == -1) at_high /= 2;
        side = -1;
      } else {
        high = angle;
        at_high = value;
        if (side == 1) at_low /= 2;
        side = 1;
      }
    }
  }
  return half_plane_of_area(cell, turned(guess, angle), area);
}

}  // namespace wetfront::mpm
