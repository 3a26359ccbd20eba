#pragma once

#include <array>

namespace wetfront::verification::exact {

/// A manufactured motion of a neo-Hookean body, P = lambda ln J F^-T + mu (F - F^-T), in a unit square or cube
/// (Wallstedt & Guilkey 2008; Kamojjala et al. 2015): each axis moves along itself, so F is diagonal and sides only
/// slide,
///   u_i = A sin(2 pi X_i) sin(c pi t + phase_i),
///   b_i = pi^2 u_i (4 mu/rho - c^2 - 4 [lambda (ln J - 1) - mu]/(rho F_ii^2)).
/// On the sides X_i = 0 and 1 u_i = 0. With one axis, lambda = 0 and mu = E/2: P = E/2 (F - 1/F), Uintah's 1-D case.
struct AxisAlignedMotion {
  int dim;                      ///< 1, 2 or 3
  double lame, shear_modulus;   ///< lambda, mu [Pa]
  double density;               ///< rho_0 [kg/m3]
  double amplitude;             ///< A [m], 2 pi A < 1
  double speed;                 ///< c [m/s]
  std::array<double, 3> phase;  ///< rad
};

/// std::invalid_argument where cells would invert (2 pi A >= 1) or parameters are not positive. X are places at rest.
class AxisAlignedSolution {
 public:
  using Vector = std::array<double, 3>;
  explicit AxisAlignedSolution(const AxisAlignedMotion& problem);
  Vector displacement(const Vector& x, double t) const;
  Vector velocity(const Vector& x, double t) const;
  Vector body_force(const Vector& x, double t) const;  ///< per mass [m/s2]
  Vector stretch(const Vector& x, double t) const;     ///< F_ii
  Vector stress(const Vector& x, double t) const;      ///< Cauchy, along the axes [Pa]; out of plane too in 1-D and 2-D

 private:
  double log_volume(const Vector& stretch) const;
  AxisAlignedMotion p_;
};

}  // namespace wetfront::verification::exact
