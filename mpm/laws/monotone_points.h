#pragma once

#include "mpm/laws/log_table.h"

#include <vector>

namespace wetfront::mpm {

/// Interpolates points by cubics with a continuous slope that fall only where the points do (Fritsch & Butland 1984,
/// SIAM J. Sci. Stat. Comput. 5:300): slopes are weighted harmonic means of the neighbouring chords, those of the
/// chords themselves at both ends. Constant beyond the last point.
class MonotonePoints {
 public:
  /// At least two points, x ascending.
  MonotonePoints(std::vector<double> x, std::vector<double> y);
  ValueAndSlope at(double x) const;
  /// Largest x up to which the value stays that of the first point.
  double plateau() const;

 private:
  double chord(std::size_t piece) const { return (y_[piece + 1] - y_[piece]) / (x_[piece + 1] - x_[piece]); }
  std::vector<double> x_, y_, slope_;
};

}  // namespace wetfront::mpm
