#pragma once

#include <functional>

namespace wetfront::verification::exact {

/// de Boer, Ehlers & Liu 1993 (Archive of Applied Mechanics 63:59-72): a half-space of elastic skeleton with
/// incompressible grains and incompressible water, loaded at its drained surface z = 0 (z down), at rest before:
///   a u_tt + b u_t = u_zz,  a = (nF^2 rho^S + nS^2 rho^F)/((lambda + 2 mu) nF^2),  b = gamma_F/(k (lambda + 2 mu)),
///   u = 1/(sqrt a (lambda + 2 mu)) int_{sqrt a z}^t f(t - tau) exp(-b tau/2a) I_0(b sqrt(tau^2 - a z^2)/2a) d tau.
/// rho^S, rho^F are partial densities. Skeleton and water both carry inertia. SI units; u and z down, f compressive.
struct DeBoerColumn {
  double lame;                         ///< lambda [Pa]
  double shear_modulus;                ///< mu [Pa]
  double solid_fraction;               ///< nS [-]
  double grain_density;                ///< rho^SR [kg/m3]
  double water_density;                ///< rho^FR [kg/m3]
  double conductivity;                 ///< k [m/s]
  double water_unit_weight;            ///< gamma_F [N/m3]
  std::function<double(double)> load;  ///< f(t), effective stress on the drained surface [Pa]
};

/// std::invalid_argument for non-positive parameters.
class DeBoerSolution {
 public:
  explicit DeBoerSolution(const DeBoerColumn& problem);
  double wave_speed() const;                      ///< 1/sqrt(a) [m/s]
  double displacement(double z, double t) const;  ///< of the skeleton [m]; 0 before the wave arrives

 private:
  DeBoerColumn p_;
  double modulus_, a_, b_;
};

}  // namespace wetfront::verification::exact
