#pragma once

#include <array>
#include <cmath>

namespace wetfront::verification::exact {

/// Derivative by central differences and Richardson extrapolation (Ridders 1982): steps fall by 2 from `step`, the
/// entry of the tableau with the smallest change is taken. `order` is 1 or 2. Good to about 1e-10 (first) and 1e-7
/// (second) of f/step^order for a smooth f with 15 digits; `step` should be a fraction of the length over which f
/// changes.
template <class Function>
double derivative(const Function& f, double x, double step, int order = 1) {
  constexpr int levels = 8;
  std::array<std::array<double, levels>, levels> a{};
  double best = 0, error = INFINITY;
  for (int i = 0; i < levels; ++i, step /= 2) {
    a[i][0] =
        order == 1 ? (f(x + step) - f(x - step)) / (2 * step) : (f(x + step) - 2 * f(x) + f(x - step)) / (step * step);
    double factor = 4;
    for (int j = 1; j <= i; ++j, factor *= 4) {
      a[i][j] = (factor * a[i][j - 1] - a[i - 1][j - 1]) / (factor - 1);
      const double change = std::max(std::abs(a[i][j] - a[i][j - 1]), std::abs(a[i][j] - a[i - 1][j - 1]));
      if (change < error) error = change, best = a[i][j];
    }
  }
  return best;
}

/// The terms of a balance `rate = sum`, and how far it fails relative to the largest of them.
inline double relative_residual(double rate, double sum, double scale = 0) {
  return std::abs(rate - sum) / std::max({std::abs(rate), std::abs(sum), scale});
}

}  // namespace wetfront::verification::exact
