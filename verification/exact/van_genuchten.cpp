#include "verification/exact/van_genuchten.h"

#include <cmath>

#include "verification/exact/bisect.h"
#include "verification/exact/validity.h"

namespace wetfront::verification::exact {

void VanGenuchten::validate() const {
  require_problem(theta_r >= 0 && theta_s > theta_r, "van Genuchten: 0 <= theta_r < theta_s is required");
  require_problem(alpha > 0 && n > 1 && conductivity > 0, "van Genuchten: alpha > 0, n > 1, Ks > 0 are required");
}

double VanGenuchten::saturation(double head) const {
  if (head >= 0) return 1;
  return std::exp(-(1 - 1 / n) * std::log1p(std::pow(-alpha * head, n)));
}

double VanGenuchten::content(double head) const {
  return theta_r + (theta_s - theta_r) * saturation(head);
}

double VanGenuchten::relative_conductivity(double head) const {
  if (head >= 0) return 1;
  const double m = 1 - 1 / n, x = std::pow(-alpha * head, n);
  // 1 - Se^{1/m} = x/(1 + x) = 1/(1 + 1/x): its logarithm is -log1p(1/x).
  const double bracket = -std::expm1(-m * std::log1p(1 / x));
  return std::sqrt(saturation(head)) * bracket * bracket;
}

double VanGenuchten::capacity(double head) const {
  if (head >= 0) return 0;
  const double m = 1 - 1 / n, x = std::pow(-alpha * head, n);
  return (theta_s - theta_r) * m * n * saturation(head) * x / ((1 + x) * -head);
}

double VanGenuchten::head_of_saturation(double se) const {
  require_point(se > 0 && se <= 1, "van Genuchten: Se outside (0, 1]");
  const double m = 1 - 1 / n;
  return -std::pow(std::expm1(-std::log(se) / m), 1 / n) / alpha;
}

double VanGenuchten::head_of_conductivity(double value) const {
  require_point(value > 0 && value <= conductivity, "van Genuchten: no head gives this conductivity");
  if (value == conductivity) return 0;
  // in the logarithm of suction, from where K is Ks to rounding to where it underflows
  const auto drier = [&](double log_x) {
    return conductivity * relative_conductivity(-std::exp(log_x) / alpha) < value;
  };
  return -std::exp(bisect(drier, -700 / n, 700 / n)) / alpha;
}

double VanGenuchten::diffusivity(double se) const {
  const double head = head_of_saturation(se);
  return conductivity * relative_conductivity(head) / capacity(head);
}

}  // namespace wetfront::verification::exact
