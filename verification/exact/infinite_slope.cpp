#include "verification/exact/infinite_slope.h"

#include "verification/exact/bisect.h"
#include "verification/exact/soil_strength.h"
#include "verification/exact/validity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification::exact {
namespace {

constexpr double largest = 1e6;

/// A plane that is pushed apart has no friction.
double effective(const PlaneLoad& load) {
  require_problem(load.shear > 0, "infinite slope: the plane has to be sheared");
  return std::max(0.0, load.normal - load.pore);
}

double davis_strength(const PlaneLoad& load, const PlaneStrength& s) {
  return davis_cohesion(s.friction, s.dilatancy, s.cohesion) +
         effective(load) * davis_friction(s.friction, s.dilatancy);
}

}  // namespace

double limit_safety(const PlaneLoad& load, const PlaneStrength& strength) {
  return (strength.cohesion + effective(load) * std::tan(strength.friction)) / load.shear;
}

double davis_safety(const PlaneLoad& load, const PlaneStrength& strength) {
  return davis_strength(load, strength) / load.shear;
}

double reduced_safety(const PlaneLoad& load, const PlaneStrength& strength) {
  const auto fails = [&](double factor) {
    const PlaneStrength weak = {std::atan(std::tan(strength.friction) / factor),
                                std::atan(std::tan(strength.dilatancy) / factor), strength.cohesion / factor};
    return davis_strength(load, weak) < load.shear;
  };
  if (!fails(largest)) return std::numeric_limits<double>::infinity();
  if (fails(1 / largest)) return 0;
  return bisect(fails, 1 / largest, largest);
}

}  // namespace wetfront::verification::exact
