#include "verification/exact/gravity_column.h"

#include <cmath>

#include "verification/exact/bisect.h"
#include "verification/exact/quadrature.h"
#include "verification/exact/validity.h"

namespace wetfront::verification::exact {

GravityColumnSolution::GravityColumnSolution(const GravityColumn& p, ColumnLaw law) : p_(p), law_(law) {
  require_problem(p.height > 0 && p.density > 0 && p.gravity > 0 && p.young > 0 && p.poisson >= 0 && p.poisson < 0.5,
                  "gravity column: height, density, gravity and modulus must be > 0, 0 <= nu < 0.5");
  modulus_ = p.young * (1 - p.poisson) / ((1 + p.poisson) * (1 - 2 * p.poisson));
}

/// The column keeps its width, so the nominal stress along it is the Cauchy stress and J is the stretch.
double GravityColumnSolution::stretch(double x) const {
  require_point(x >= 0 && x <= p_.height, "gravity column: X outside [0, H]");
  const double load = p_.density * p_.gravity * (p_.height - x) / modulus_;
  switch (law_) {
    case ColumnLaw::small_strain:
      return 1 - load;
    case ColumnLaw::rate:
      return std::exp(-load);
    case ColumnLaw::hencky:
      break;
  }
  // ln s = -load s, monotone in s in (0, 1]
  return bisect([&](double s) { return std::log(s) + load * s > 0; }, 1e-300, 1);
}

double GravityColumnSolution::position(double x) const {
  if (x == 0) return 0;
  return integrate([this](double at) { return stretch(at); }, 0, x, 1e-13);
}

double GravityColumnSolution::height() const {
  return position(p_.height);
}

double GravityColumnSolution::settlement() const {
  return integrate([this](double at) { return 1 - stretch(at); }, 0, p_.height, 1e-13);
}

double GravityColumnSolution::vertical_stress(double x) const {
  return -p_.density * p_.gravity * (p_.height - x);
}

double GravityColumnSolution::stress_ratio() const {
  return p_.poisson / (1 - p_.poisson);
}

double GravityColumnSolution::period() const {
  return 4 * p_.height / std::sqrt(modulus_ / p_.density);
}

}  // namespace wetfront::verification::exact
