#include "verification/exact/undrained.h"

#include <cmath>

#include "verification/exact/validity.h"

namespace wetfront::verification::exact {

double undrained_modulus(const Undrained& soil) {
  require_problem(soil.oedometer_modulus > 0 && soil.water_modulus > 0 && soil.porosity > 0 && soil.porosity < 1,
                  "undrained: moduli must be > 0, the porosity in (0, 1)");
  return soil.oedometer_modulus + soil.water_modulus / soil.porosity;
}

double undrained_pressure(const Undrained& soil, double load) {
  return load * (1 - soil.oedometer_modulus / undrained_modulus(soil));
}

double undrained_wave_speed(const Undrained& soil, double density) {
  require_problem(density > 0, "undrained: the density must be > 0");
  return std::sqrt(undrained_modulus(soil) / density);
}

}  // namespace wetfront::verification::exact
