#include "fem_reference/stage/flat_top.h"

namespace wetfront::fem_reference {

std::vector<FlatTop> flat_tops(const std::vector<SoilLaw>& laws, double drop) {
  std::vector<FlatTop> tops;
  for (const SoilLaw& law : laws) {
    const double full = -law.air_entry(), target = law.water_content(0).value - drop;
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (law.water_content(full - middle).value > target ? low : high) = middle;
    }
    tops.push_back({full, high});
  }
  return tops;
}

}  // namespace wetfront::fem_reference
