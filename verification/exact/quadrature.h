#pragma once

#include <array>
#include <cmath>

#include "verification/exact/validity.h"

namespace wetfront::verification::exact {

namespace detail {

struct Panel {
  double integral, error;
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
  double fine = kronrod[7] * f(middle), coarse = gauss[3] * fine / kronrod[7];
  for (int i = 0; i < 7; ++i) {
    const double pair = f(middle - half * node[i]) + f(middle + half * node[i]);
    fine += kronrod[i] * pair;
    if (i % 2 == 1) coarse += gauss[i / 2] * pair;
  }
  return {half * fine, std::abs(half * (fine - coarse))};
}

template <class Function>
double integrate_panel(const Function& f, double a, double b, double tolerance, int depth) {
  const Panel panel = gauss_kronrod(f, a, b);
  require_point(std::isfinite(panel.integral), "quadrature: the integrand is not finite");
  if (panel.error <= tolerance || depth == 0) {
    require_point(panel.error <= 1e3 * tolerance, "quadrature: no convergence in 50 halvings");
    return panel.integral;
  }
  const double middle = 0.5 * (a + b);
  return integrate_panel(f, a, middle, 0.5 * tolerance, depth - 1) +
         integrate_panel(f, middle, b, 0.5 * tolerance, depth - 1);
}

}  // namespace detail

/// Integral of f over [a, b] by adaptive halving, to `relative` of a first estimate of the integral of |f| (the 7-point
/// rule's error bounds the 15-point rule's far from above). Throws std::domain_error if it does not converge.
template <class Function>
double integrate(const Function& f, double a, double b, double relative = 1e-12) {
  if (a == b) return 0;
  const double size = std::abs(detail::gauss_kronrod([&](double x) { return std::abs(f(x)); }, a, b).integral);
  return detail::integrate_panel(f, a, b, relative * size, 50);
}

}  // namespace wetfront::verification::exact
