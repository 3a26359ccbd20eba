#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

#include "verification/exact/validity.h"

namespace wetfront::verification::exact {

namespace detail {

struct Panel {
  double left, right, integral, error;
  bool operator<(const Panel& other) const { return error < other.error; }
};

/// Gauss-Kronrod 7/15 (QUADPACK qk15; nodes and weights as printed there).
template <class Function>
Panel gauss_kronrod(const Function& f, double a, double b) {
  constexpr std::array<double, 8> node = {0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
                                          0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
                                          0.586087235467691130294144691693195, 0.405845151377397166906606412076961,
                                          0.207784955007898467600689403773245, 0.0};
  constexpr std::array<double, 8> kronrod = {0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
                                             0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
                                             0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
                                             0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
  constexpr std::array<double, 4> gauss = {0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
                                           0.381830050505118944950369775488975, 0.417959183673469387755102040816327};
  const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
  const double centre = f(middle);
  double fine = kronrod[7] * centre, coarse = gauss[3] * centre, magnitude = kronrod[7] * std::abs(centre);
  for (int i = 0; i < 7; ++i) {
    const double left = f(middle - half * node[i]), right = f(middle + half * node[i]), pair = left + right;
    magnitude += kronrod[i] * (std::abs(left) + std::abs(right));
    fine += kronrod[i] * pair;
    if (i % 2 == 1) coarse += gauss[i / 2] * pair;
  }
  const double difference = std::abs(half * (fine - coarse)), size = half * magnitude;
  // QUADPACK's scaling: the difference bounds the 7-point rule, the 15-point one is far better where both are good.
  const double error = size > 0 ? size * std::min(1.0, std::pow(200 * difference / size, 1.5)) : 0;
  require_point(std::isfinite(fine), "quadrature: the integrand is not finite");
  return {a, b, half * fine, std::max(error, 2e-16 * size)};
}

}  // namespace detail

/// Integral of f over [a, b], a < b or a > b, to `relative` of the integral of |f| as the first panel sees it: the
/// panel with the largest error is halved until the errors add up to less. Throws std::domain_error after 4000 panels
/// (noise in f above `relative`, or a singularity).
template <class Function>
double integrate(const Function& f, double a, double b, double relative = 1e-12) {
  if (a == b) return 0;
  if (a > b) return -integrate(f, b, a, relative);
  const double size = detail::gauss_kronrod([&](double x) { return std::abs(f(x)); }, a, b).integral;
  std::priority_queue<detail::Panel> panels;
  panels.push(detail::gauss_kronrod(f, a, b));
  double sum = panels.top().integral, error = panels.top().error;
  while (error > relative * std::max(size, std::abs(sum))) {
    require_point(panels.size() < 4000, "quadrature: no convergence in 4000 panels");
    const detail::Panel worst = panels.top();
    panels.pop();
    const double middle = 0.5 * (worst.left + worst.right);
    sum -= worst.integral, error -= worst.error;
    for (const auto& half :
         {detail::gauss_kronrod(f, worst.left, middle), detail::gauss_kronrod(f, middle, worst.right)}) {
      sum += half.integral, error += half.error;
      panels.push(half);
    }
  }
  return sum;
}

}  // namespace wetfront::verification::exact
