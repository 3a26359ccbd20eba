#include "verification/compare/gates.h"

#include "verification/scene/quantities.h"

#include <cmath>

namespace wetfront::verification {

std::optional<double> narrowest_gate(const Scene& scene, const std::string& quantity) {
  std::optional<double> narrowest;
  for (const Tolerance& tolerance : scene.comparison.tolerances)
    if (tolerance.quantity == quantity && (!narrowest || tolerance.value < *narrowest)) narrowest = tolerance.value;
  return narrowest;
}

double gate_on(const Scene& scene, const std::string& quantity, double value) {
  const auto gate = narrowest_gate(scene, quantity);
  if (!gate) return 0;
  return find_quantity(quantity)->unit == "1" ? *gate * std::abs(value) : *gate;
}

}  // namespace wetfront::verification
