#pragma once

#include "mpm/plan/column.h"
#include "mpm/seepage/conduction.h"

namespace wetfront::mpm {

/// The liquid's inertia in Darcy's law on a rigid skeleton, backward Euler (mpm/README.md section 3):
///
///   rho/(n S) (q - q_old)/dt = -(grad p - rho g) - q/M  =>  q = theta q_old - M_eff (grad p - rho g),
///   theta = M/(M + a), M_eff = M a/(M + a), a = n S dt/rho, M = k k_rel/mu, S at the start of the step.
///
/// a -> infinity (large steps) is Darcy's law, M -> infinity a liquid without drag.
template <int dim>
struct LiquidInertia {
  const Column *flux, *saturation;  ///< of the points, at the start of the step
  double porosity_over_density;     ///< n/rho [m3/kg]

  struct AtPoint {
    Vector<dim> flux;  ///< q_old along the principal axes
    double a;
    AxisFlux operator()(int axis, double mobility) const {
      const double share = a / (mobility + a), old = flux[axis];
      return {mobility * share, share * share, (1 - share) * old, share * old / (mobility + a)};
    }
  };
  template <class Tensor>
  AtPoint at(std::size_t point, double dt, const Tensor& tensor) const {
    Vector<dim> old{};
    for (int c = 0; c < dim; ++c) old[c] = (*flux)[c][point];
    return {tensor.to_axes(old), porosity_over_density * (*saturation)[0][point] * dt};
  }
  void drive(std::size_t, Vector<dim>&) const {}
};

/// The same against grains that move (coupling/README.md section 8b): the body force is g - a_s, and "saturation" is
/// n S/(1 - rho_l n S/rho), since the body gives way to what its water does.
template <int dim>
struct LiquidInertiaInMotion : LiquidInertia<dim> {
  const Column* acceleration;  ///< a_s of the points [m/s2]
  double density;              ///< of the liquid [kg/m3]

  void drive(std::size_t point, Vector<dim>& slope) const {
    for (int c = 0; c < dim; ++c) slope[c] += density * (*acceleration)[c][point];
  }
};

}  // namespace wetfront::mpm
