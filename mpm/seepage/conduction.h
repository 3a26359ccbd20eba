#pragma once

#include "mpm/grid/stencil.h"
#include "mpm/problem.h"

#include <cmath>

/// What a scene may add to Darcy's law, as value types that the flux kernel is compiled for.
namespace wetfront::mpm {

/// Nothing but grad p drives the water.
template <int dim>
struct PressureOnly {
  void operator()(Vector<dim>&) const {}
};
/// grad p - rho g.
template <int dim>
struct PressureAndWeight {
  Vector<dim> weight;  ///< rho g [Pa/m]
  void operator()(Vector<dim>& gradient) const {
    for (int a = 0; a < dim; ++a) gradient[a] -= weight[a];
  }
};

template <int dim>
struct Isotropic {
  Vector<dim> to_axes(const Vector<dim>& v) const { return v; }
  Vector<dim> from_axes(const Vector<dim>& v) const { return v; }
  static constexpr double factor(int) { return 1; }
};

/// A symmetric tensor T by its principal axes: T = Q diag(t) Q^T.
template <int dim>
struct Anisotropic {
  std::array<Vector<dim>, dim> axis{};  ///< unit vectors, the rows of Q^T
  Vector<dim> factors{};

  explicit Anisotropic(const std::array<double, 6>& tensor);
  double factor(int a) const { return factors[a]; }
  Vector<dim> to_axes(const Vector<dim>& v) const {
    Vector<dim> out{};
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) out[a] += axis[a][b] * v[b];
    return out;
  }
  Vector<dim> from_axes(const Vector<dim>& v) const {
    Vector<dim> out{};
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) out[b] += axis[a][b] * v[a];
    return out;
  }
};

/// Jacobi's rotations; `tensor` is {xx, yy, zz, xy, yz, zx}.
template <int dim>
Anisotropic<dim>::Anisotropic(const std::array<double, 6>& tensor) {
  double t[3][3] = {
      {tensor[0], tensor[3], tensor[5]}, {tensor[3], tensor[1], tensor[4]}, {tensor[5], tensor[4], tensor[2]}};
  for (int a = 0; a < dim; ++a) axis[a][a] = 1;
  for (int sweep = 0; sweep < 20; ++sweep)
    for (int a = 0; a < dim; ++a)
      for (int b = a + 1; b < dim; ++b) {
        const double angle = 0.5 * std::atan2(2 * t[a][b], t[a][a] - t[b][b]);
        const double c = std::cos(angle), s = std::sin(angle);
        for (int k = 0; k < dim; ++k) {
          const double x = t[a][k], y = t[b][k];
          t[a][k] = c * x + s * y;
          t[b][k] = c * y - s * x;
          const double u = axis[a][k], v = axis[b][k];
          axis[a][k] = c * u + s * v;
          axis[b][k] = c * v - s * u;
        }
        for (int k = 0; k < dim; ++k) {
          const double x = t[k][a], y = t[k][b];
          t[k][a] = c * x + s * y;
          t[k][b] = c * y - s * x;
        }
      }
  for (int a = 0; a < dim; ++a) factors[a] = t[a][a];
}

inline bool is_isotropic(const Soil& soil) {
  return soil.anisotropy == std::array<double, 6>{1, 1, 1, 0, 0, 0};
}

/// Along one principal axis q = theta q_old - M_eff drive, and how both follow the mobility M = k k_rel / mu.
struct AxisFlux {
  double mobility, mobility_slope;  ///< M_eff [m2/(Pa s)], dM_eff/dM
  double memory, memory_slope;      ///< theta q_old [m/s], its derivative by M
};

/// q = -M drive.
template <int dim>
struct NoInertia {
  struct AtPoint {
    AxisFlux operator()(int, double mobility) const { return {mobility, 1, 0, 0}; }
  };
  template <class Tensor>
  AtPoint at(std::size_t, double, const Tensor&) const {
    return {};
  }
  void drive(std::size_t, Vector<dim>&) const {}
};

}  // namespace wetfront::mpm
