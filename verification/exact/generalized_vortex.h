#pragma once

#include <array>

namespace wetfront::verification::exact {

/// Kamojjala, Brannon, Sadeghirad & Guilkey 2015, generalized vortex: a neo-Hookean ring turns against itself without
/// change of volume, x = Q(alpha) X, alpha = g(t) h(R), g = G sin(pi t/T), h = 1 - 8 s^2 + 16 s^4,
/// s = (R - (Ri + Ro)/2)/(Ro - Ri). Outside of the ring, where h = h' = 0, all is at rest without stress. The body
/// force in the frame turned by alpha, with the signs corrected (the widespread "vortexBodyForces" is wrong;
/// benchmarks.md 6):
///   b_r = -R (g' h)^2 + (mu/rho) R (g h')^2,  b_t = R g'' h - (mu/rho)(3 g h' + R g h'').
struct GeneralizedVortex {
  double inner = 0.75, outer = 1.25;  ///< Ri, Ro [m]
  double amplitude = 1;               ///< G [rad]
  double duration = 1;                ///< T [s]
  double shear_modulus = 1000 / 2.6;  ///< mu [Pa]
  double density = 1000;              ///< kg/m3
};

class GeneralizedVortexSolution {
 public:
  using Vector = std::array<double, 2>;
  /// std::invalid_argument for a ring without width or non-positive parameters.
  explicit GeneralizedVortexSolution(const GeneralizedVortex& problem);
  double angle(const Vector& x, double t) const;     ///< alpha [rad]
  Vector position(const Vector& x, double t) const;  ///< of what was at X
  Vector velocity(const Vector& x, double t) const;
  Vector body_force(const Vector& x, double t) const;  ///< per mass [m/s2]

 private:
  struct Profile {
    double value, slope, curvature;
  };
  Profile profile(double radius) const;
  struct Time {
    double value, rate, acceleration;
  };
  Time in_time(double t) const;
  GeneralizedVortex p_;
};

}  // namespace wetfront::verification::exact
