#include "mpm/laws/monotone_points.h"

#include <algorithm>

namespace wetfront::mpm {

MonotonePoints::MonotonePoints(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)) {
  const std::size_t last = x_.size() - 1;
  slope_.assign(x_.size(), 0.0);
  slope_[0] = chord(0);
  slope_[last] = chord(last - 1);
  for (std::size_t k = 1; k < last; ++k) {
    const double before = chord(k - 1), after = chord(k);
    if (!(before * after > 0)) continue;
    const double span = x_[k + 1] - x_[k - 1];
    const double weight = (span + x_[k + 1] - x_[k]) / (3 * span);  // of the chord before
    slope_[k] = 1 / (weight / before + (1 - weight) / after);
  }
}

ValueAndSlope MonotonePoints::at(double x) const {
  if (x >= x_.back()) return {y_.back(), 0};
  if (x <= x_.front()) return {y_.front(), slope_.front()};
  const auto k = static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), x) - x_.begin()) - 1;
  const double h = x_[k + 1] - x_[k], t = (x - x_[k]) / h, r = 1 - t;
  const double value =
      r * r * ((1 + 2 * t) * y_[k] + t * h * slope_[k]) + t * t * ((1 + 2 * r) * y_[k + 1] - r * h * slope_[k + 1]);
  const double slope = 6 * t * r * chord(k) + r * (1 - 3 * t) * slope_[k] + t * (1 - 3 * r) * slope_[k + 1];
  return {value, slope};
}

double MonotonePoints::plateau() const {
  std::size_t k = 0;
  while (k + 1 < y_.size() && y_[k + 1] == y_[0]) ++k;
  return x_[k];
}

}  // namespace wetfront::mpm
