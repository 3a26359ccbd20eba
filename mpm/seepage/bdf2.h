#pragma once

namespace wetfront::mpm {

/// One step of backward Euler or of the variable-step BDF2 formula for dW/dt = R:
/// now W^{n+1} + last W^n + before W^{n-1} = dt R(t^{n+1}).
struct Bdf2Weights {
  double now = 1, last = -1, before = 0;

  /// `ratio` = dt / dt of the step before.
  static Bdf2Weights of(double ratio) {
    return {(1 + 2 * ratio) / (1 + ratio), -(1 + ratio), ratio * ratio / (1 + ratio)};
  }
};

/// Extrapolation through the last two or three values to the end of the next step, and what fraction of
/// (computed - extrapolated) estimates the local error of that step.
///
/// With num - exact = c h^k y^(k) and exact - extrapolated = q h^k y^(k), the error is c/(c+q) of the difference:
/// backward Euler and a straight line (k = 2): c = 1/2, q = (h+h1)/(2h); BDF2 and a parabola (k = 3):
/// c = (1+w)^2/(6w(1+2w)), q = (h+h1)(h+h1+h2)/(6h^2), w = h/h1. (2/11 for equal steps.)
struct StepPredictor {
  double last = 1, before = 0, earlier = 0;  ///< weights of y^n, y^{n-1}, y^{n-2}
  double error_fraction = 0;                 ///< 0: no estimate possible
  int order = 1;                             ///< of the formula whose error is estimated

  /// Only y^n is known (start, break): nothing to extrapolate from.
  static StepPredictor constant() { return {}; }
  static StepPredictor line(double h, double h1) {
    const double c = 0.5, q = (h + h1) / (2 * h);
    return {1 + h / h1, -h / h1, 0, c / (c + q), 1};
  }
  static StepPredictor parabola(double h, double h1, double h2) {
    const double w = h / h1;
    const double c = (1 + w) * (1 + w) / (6 * w * (1 + 2 * w)), q = (h + h1) * (h + h1 + h2) / (6 * h * h);
    return {(h + h1) * (h + h1 + h2) / (h1 * (h1 + h2)), -h * (h + h1 + h2) / (h1 * h2),
            h * (h + h1) / (h2 * (h1 + h2)), c / (c + q), 2};
  }
};

}  // namespace wetfront::mpm
