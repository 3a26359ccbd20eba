#include "verification/exact/green_ampt.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "verification/exact/lambert_w.h"
#include "verification/exact/validity.h"

namespace wetfront::verification::exact {

GreenAmptSolution::GreenAmptSolution(const GreenAmpt& p)
    : k_(p.conductivity * std::cos(p.angle)),
      s_(p.front_suction * p.deficit / std::cos(p.angle)),
      cosine_(std::cos(p.angle)) {
  require_problem(p.conductivity > 0 && p.front_suction > 0, "Green-Ampt: K and the front suction must be > 0");
  require_problem(p.deficit > 0 && p.deficit <= 1, "Green-Ampt: the content deficit must lie in (0, 1]");
  require_problem(p.angle >= 0 && p.angle < std::numbers::pi / 2, "Green-Ampt: angle outside [0, pi/2)");
}

double GreenAmptSolution::ponded_infiltration(double t) const {
  require_point(t >= 0, "Green-Ampt: t < 0");
  return s_ * lower_branch(k_ * t / s_);
}

double GreenAmptSolution::capacity(double infiltrated) const {
  require_point(infiltrated > 0, "Green-Ampt: the capacity is infinite before anything has entered");
  return k_ * (1 + s_ / infiltrated);
}

double GreenAmptSolution::time_to_ponding(double rain) const {
  require_problem(rain >= 0, "Green-Ampt: rain < 0");
  const double entering = rain * cosine_;
  if (entering <= k_) return std::numeric_limits<double>::infinity();
  return s_ * k_ / (entering - k_) / entering;
}

double GreenAmptSolution::rain_infiltration(double rain, double t) const {
  require_point(t >= 0, "Green-Ampt: t < 0");
  const double ponding = time_to_ponding(rain), entering = rain * cosine_;
  if (t <= ponding) return entering * t;
  const double at_ponding = entering * ponding;
  // F - S ln(1 + F/S) has the value of F_p at t_p and grows by K (t - t_p)
  const double start = at_ponding / s_ - std::log1p(at_ponding / s_);
  return s_ * lower_branch(start + k_ * (t - ponding) / s_);
}

}  // namespace wetfront::verification::exact
