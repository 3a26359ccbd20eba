#include "fem_reference/soil/monotone_cubic.h"

#include <algorithm>

namespace wetfront::fem_reference {

MonotoneCubic::MonotoneCubic(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)), slope_(x_.size(), 0.0) {
  const std::size_t n = x_.size();
  std::vector<double> secant(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) secant[i] = (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]);
  slope_.front() = secant.front();
  slope_.back() = secant.back();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = secant[i - 1], right = secant[i];
    if (left * right <= 0) continue;  // a flat piece or an extremum: slope 0
    // Weighted harmonic mean (Fritsch & Butland 1984): never steeper than three times the flatter neighbour.
    const double hl = x_[i] - x_[i - 1], hr = x_[i + 1] - x_[i];
    const double wl = 2 * hr + hl, wr = hr + 2 * hl;
    slope_[i] = (wl + wr) / (wl / left + wr / right);
  }
}

ValueAndSlope MonotoneCubic::operator()(double x) const {
  if (x <= x_.front()) return {y_.front(), 0};
  if (x >= x_.back()) return {y_.back(), 0};
  const std::size_t i = std::upper_bound(x_.begin(), x_.end(), x) - x_.begin() - 1;
  const double h = x_[i + 1] - x_[i], t = (x - x_[i]) / h;
  const double rise = y_[i + 1] - y_[i];
  // Hermite form about the left point: y = y_i + h t (m_i + t (c2 + t c3)).
  const double secant = rise / h;
  const double c2 = 3 * secant - 2 * slope_[i] - slope_[i + 1], c3 = slope_[i] + slope_[i + 1] - 2 * secant;
  return {y_[i] + h * t * (slope_[i] + t * (c2 + t * c3)), slope_[i] + t * (2 * c2 + 3 * t * c3)};
}

}  // namespace wetfront::fem_reference
