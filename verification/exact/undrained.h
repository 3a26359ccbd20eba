#pragma once

namespace wetfront::verification::exact {

/// Saturated soil whose water has no time to leave: skeleton and water strain as one. SI units.
struct Undrained {
  double oedometer_modulus;  ///< M [Pa]
  double water_modulus;      ///< K_w [Pa]
  double porosity;           ///< n
};

double undrained_modulus(const Undrained& soil);  ///< M + K_w/n [Pa]
double undrained_pressure(const Undrained& soil,
                          double load);  ///< p under a confined load [Pa], load (K_w/n)/(M + K_w/n)
/// Of the fast compression wave through the mixture of that density [m/s].
double undrained_wave_speed(const Undrained& soil, double density);

}  // namespace wetfront::verification::exact
