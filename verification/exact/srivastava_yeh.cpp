#include "verification/exact/srivastava_yeh.h"

#include <cmath>
#include <numbers>

#include "verification/exact/bisect.h"
#include "verification/exact/series.h"
#include "verification/exact/validity.h"

namespace wetfront::verification::exact {
namespace {

/// Root of sin(lambda L) + 2 lambda cos(lambda L), the only one with lambda L in ((k - 1/2) pi, k pi). There tan rises
/// from -infinity to 0 and 2 lambda is positive, so there is exactly one; the sign at the left end is that of sin.
double root(int k, double length) {
  const bool left_is_positive = k % 2 == 1;
  const auto past = [&](double lambda) {
    return (std::sin(lambda * length) + 2 * lambda * std::cos(lambda * length) > 0) != left_is_positive;
  };
  return bisect(past, (k - 0.5) * std::numbers::pi / length, k * std::numbers::pi / length);
}

void validate(const SrivastavaYeh& p, int terms) {
  require_problem(p.alpha > 0 && p.conductivity > 0 && p.thickness > 0, "Srivastava-Yeh: alpha, Ks, L must be > 0");
  require_problem(p.theta_s > p.theta_r, "Srivastava-Yeh: theta_s must exceed theta_r");
  require_problem(p.base_head <= 0, "Srivastava-Yeh: base_head must be <= 0 (the exponential law ends at psi = 0)");
  require_problem(p.flux_before <= p.conductivity && p.flux_after <= p.conductivity,
                  "Srivastava-Yeh: a flux above Ks would saturate the layer");
  require_problem(terms >= 1, "Srivastava-Yeh: at least one term");
}

}  // namespace

SrivastavaYehSolution::SrivastavaYehSolution(const SrivastavaYeh& problem, int terms)
    : p_(problem),
      length_(problem.alpha * problem.thickness),
      before_(problem.flux_before / problem.conductivity),
      after_(problem.flux_after / problem.conductivity),
      time_scale_(problem.alpha * problem.conductivity / (problem.theta_s - problem.theta_r)) {
  validate(problem, terms);
  require_problem(steady(before_, length_) > 0 && steady(after_, length_) > 0,
                  "Srivastava-Yeh: evaporation beyond what the water table can supply");
  for (int k = 1; k <= terms; ++k) roots_.push_back(root(k, length_));
}

double SrivastavaYehSolution::steady(double flux, double z) const {
  return flux - (flux - std::exp(p_.alpha * p_.base_head)) * std::exp(-z);
}

double SrivastavaYehSolution::relative_conductivity(double z_metres, double t_seconds) const {
  require_point(t_seconds >= 0, "Srivastava-Yeh: t < 0");
  // Callers compute heights by sums; a few roundings beyond the surface are still the surface.
  require_point(z_metres >= -1e-12 * p_.thickness && z_metres <= (1 + 1e-12) * p_.thickness,
                "Srivastava-Yeh: z outside [0, L]");
  const double z = p_.alpha * z_metres, t = time_scale_ * t_seconds;
  if (t == 0) return steady(before_, z);
  DecayingSeries series;
  bool complete = false;
  for (double lambda : roots_) {
    const double decay = lambda * lambda * t;
    if ((complete = decay > DecayingSeries::negligible)) break;
    series.add(std::sin(lambda * z) * std::sin(lambda * length_) * std::exp(-decay) /
               (1 + length_ / 2 + 2 * lambda * lambda * length_));
  }
  return series.subtract_from(steady(after_, z), 4 * (after_ - before_) * std::exp((length_ - z) / 2 - t / 4), complete,
                              "Srivastava-Yeh");
}

double SrivastavaYehSolution::head(double z, double t) const {
  return std::log(relative_conductivity(z, t)) / p_.alpha;
}

double SrivastavaYehSolution::content(double z, double t) const {
  return p_.theta_r + (p_.theta_s - p_.theta_r) * relative_conductivity(z, t);
}

double SrivastavaYehSolution::water_table_flux(double t_seconds) const {
  require_point(t_seconds >= 0, "Srivastava-Yeh: t < 0");
  const double t = time_scale_ * t_seconds;
  if (t == 0) return p_.flux_before;
  DecayingSeries series;
  bool complete = false;
  for (double lambda : roots_) {
    const double decay = lambda * lambda * t;
    if ((complete = decay > DecayingSeries::negligible)) break;
    series.add(lambda * std::sin(lambda * length_) * std::exp(-decay) /
               (1 + length_ / 2 + 2 * lambda * lambda * length_));
  }
  return p_.conductivity * series.subtract_from(after_, 4 * (after_ - before_) * std::exp(length_ / 2 - t / 4),
                                                complete, "Srivastava-Yeh water table flux");
}

}  // namespace wetfront::verification::exact
