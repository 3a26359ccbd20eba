#include "verification/exact/warrick.h"

#include <cmath>
#include <numbers>

#include "verification/exact/erfcx.h"
#include "verification/exact/validity.h"

namespace wetfront::verification::exact {

WarrickSolution::WarrickSolution(const Warrick& problem) : p_(problem) {
  require_problem(p_.alpha > 0 && p_.conductivity > 0, "Warrick: alpha and Ks must be > 0");
  require_problem(p_.theta_s > p_.theta_r, "Warrick: theta_s must exceed theta_r");
  require_problem(p_.initial_flux > 0 && p_.initial_flux <= p_.conductivity,
                  "Warrick: the initial flux must lie in (0, Ks]");
  double last = 0;
  for (const Warrick::Step& step : p_.steps) {
    require_problem(step.start >= last, "Warrick: steps must ascend in time from 0");
    require_problem(step.flux <= p_.conductivity, "Warrick: a flux above Ks would saturate the surface");
    last = step.start;
  }
}

double WarrickSolution::step_response(double z, double t) {
  if (t <= 0) return 0;
  const double root = 2 * std::sqrt(t), near = (z - t) / root, gauss = std::exp(-near * near);
  return 0.5 * std::erfc(near) + std::sqrt(t) * std::numbers::inv_sqrtpi * gauss -
         0.5 * (1 + z + t) * gauss * erfcx((z + t) / root);
}

double WarrickSolution::relative_conductivity(double z, double t) const {
  require_point(z >= 0 && t >= 0, "Warrick: z >= 0 (down) and t >= 0 are required");
  const double time_scale = p_.alpha * p_.conductivity / (p_.theta_s - p_.theta_r);
  double flux = p_.initial_flux, sum = p_.initial_flux;
  for (const Warrick::Step& step : p_.steps) {
    sum += (step.flux - flux) * step_response(p_.alpha * z, time_scale * (t - step.start));
    flux = step.flux;
  }
  require_point(sum > 0, "Warrick: evaporation has drawn the soil dry here");
  return sum / p_.conductivity;
}

double WarrickSolution::head(double z, double t) const {
  return std::log(relative_conductivity(z, t)) / p_.alpha;
}

double WarrickSolution::content(double z, double t) const {
  return p_.theta_r + (p_.theta_s - p_.theta_r) * relative_conductivity(z, t);
}

}  // namespace wetfront::verification::exact
