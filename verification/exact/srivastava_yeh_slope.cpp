#include "verification/exact/srivastava_yeh_slope.h"

#include <cmath>
#include <numbers>

#include "verification/exact/validity.h"

namespace wetfront::verification::exact {
namespace {

/// The level layer whose dimensionless problem is the slope's: alpha and Ks shrink by cos beta, psi/cos beta is its
/// head (alpha psi is what both share).
SrivastavaYeh level(const SrivastavaYehSlope& p) {
  require_problem(p.angle >= 0 && p.angle < std::numbers::pi / 2, "Srivastava-Yeh slope: angle outside [0, pi/2)");
  const double c = std::cos(p.angle);
  return {p.alpha * c, p.conductivity * c, p.theta_r,        p.theta_s,
          p.thickness, p.rain_before * c,  p.rain_after * c, p.base_head / c};
}

}  // namespace

SrivastavaYehSlopeSolution::SrivastavaYehSlopeSolution(const SrivastavaYehSlope& problem, int terms)
    : cosine_(std::cos(problem.angle)), level_(level(problem), terms) {}

}  // namespace wetfront::verification::exact
