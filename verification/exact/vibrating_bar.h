#pragma once

namespace wetfront::verification::exact {

/// A slender elastic bar, fixed at X = 0, free at X = L, that starts straight with the velocity of one of its modes:
///   u = (v0/w) sin(k X) sin(w t),  k = (2 mode - 1) pi/(2 L),  w = k sqrt(E/rho).
/// Small strain; lateral motion free (or nu = 0), so that Young's modulus counts. SI units.
struct VibratingBar {
  double length;    ///< L [m]
  double young;     ///< E [Pa]
  double density;   ///< rho [kg/m3]
  double velocity;  ///< v0, of the tip at the start [m/s]
  int mode = 1;
};

/// std::invalid_argument for non-positive parameters.
class VibratingBarSolution {
 public:
  explicit VibratingBarSolution(const VibratingBar& problem);
  double frequency() const { return frequency_; }  ///< w [rad/s]
  double period() const;                           ///< s
  double displacement(double x, double t) const;   ///< m
  double velocity(double x, double t) const;       ///< m/s
  double stress(double x, double t) const;         ///< tension-positive [Pa]
  double mean_velocity(double t) const;            ///< of the centre of mass [m/s]
  double energy() const;                           ///< kinetic and elastic, per cross-section [J/m2]

 private:
  VibratingBar p_;
  double wave_, frequency_;
};

}  // namespace wetfront::verification::exact
