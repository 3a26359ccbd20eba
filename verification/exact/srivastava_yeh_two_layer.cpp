#include "verification/exact/srivastava_yeh_two_layer.h"

#include <algorithm>
#include <cmath>

#include "verification/exact/series.h"
#include "verification/exact/validity.h"

namespace wetfront::verification::exact {
namespace {

double range(const SrivastavaYehTwoLayer::Layer& layer) {
  return layer.theta_s - layer.theta_r;
}

/// u_n(z), z in 1/alpha.
double value(const TwoLayerMode& m, const TwoLayerMedium& medium, double z) {
  if (z < 0) return sine_over(m.lambda_squared, z + medium.length1);
  const double x = medium.length2 - z;
  return m.amplitude * (sine_over(m.mu_squared, x) + 2 * cosine(m.mu_squared, x));
}

/// (Ks_i/Ks2)(u' + u/2), the flux carried by a mode.
double carried(const TwoLayerMode& m, const TwoLayerMedium& medium, double z) {
  if (z < 0) {
    const double x = z + medium.length1;
    return medium.ratio * (cosine(m.lambda_squared, x) + sine_over(m.lambda_squared, x) / 2);
  }
  return m.amplitude * 2 * medium.beta * m.eigenvalue * sine_over(m.mu_squared, medium.length2 - z);
}

}  // namespace

SrivastavaYehTwoLayerSolution::SrivastavaYehTwoLayerSolution(const SrivastavaYehTwoLayer& problem, int terms)
    : p_(problem),
      medium_{problem.alpha * problem.lower.thickness, problem.alpha * problem.upper.thickness,
              problem.lower.conductivity * range(problem.upper) / (problem.upper.conductivity * range(problem.lower)),
              problem.lower.conductivity / problem.upper.conductivity},
      time_scale_(problem.alpha * problem.lower.conductivity / range(problem.lower)) {
  validate(terms);
  modes_ = two_layer_modes(medium_, terms);
}

void SrivastavaYehTwoLayerSolution::validate(int terms) const {
  const double smaller = std::min(p_.lower.conductivity, p_.upper.conductivity);
  require_problem(p_.alpha > 0 && smaller > 0 && p_.lower.thickness > 0 && p_.upper.thickness > 0,
                  "Srivastava-Yeh two layers: alpha, Ks and thicknesses must be > 0");
  require_problem(range(p_.lower) > 0 && range(p_.upper) > 0, "Srivastava-Yeh two layers: theta_s must exceed theta_r");
  require_problem(p_.base_head <= 0, "Srivastava-Yeh two layers: base_head must be <= 0");
  require_problem(p_.flux_before <= smaller && p_.flux_after <= smaller,
                  "Srivastava-Yeh two layers: a flux above the smaller Ks would saturate a layer");
  for (double flux : {p_.flux_before, p_.flux_after})
    require_problem(steady(flux, 0) > 0 && steady(flux, medium_.length2) > 0,
                    "Srivastava-Yeh two layers: evaporation beyond what the water table can supply");
  require_problem(terms >= 1, "Srivastava-Yeh two layers: at least one term");
}

void SrivastavaYehTwoLayerSolution::require_inside(double z, double t) const {
  require_point(t >= 0, "Srivastava-Yeh two layers: t < 0");
  const double slack = 1e-12 * (p_.lower.thickness + p_.upper.thickness);  // heights formed by sums
  require_point(z >= -p_.lower.thickness - slack && z <= p_.upper.thickness + slack,
                "Srivastava-Yeh two layers: z outside the layers");
}

double SrivastavaYehTwoLayerSolution::steady(double flux, double z) const {
  const double q1 = flux / p_.lower.conductivity, q2 = flux / p_.upper.conductivity;
  const double base = std::exp(p_.alpha * p_.base_head);
  if (z < 0) return q1 - (q1 - base) * std::exp(-(medium_.length1 + z));
  const double interface = q1 - (q1 - base) * std::exp(-medium_.length1);
  return q2 - (q2 - interface) * std::exp(-z);
}

double SrivastavaYehTwoLayerSolution::relative_conductivity(double z_metres, double t_seconds) const {
  require_inside(z_metres, t_seconds);
  const double z = p_.alpha * z_metres, t = time_scale_ * t_seconds;
  if (t == 0) return steady(p_.flux_before, z);
  DecayingSeries series;
  bool complete = false;
  for (const TwoLayerMode& m : modes_) {
    const double decay = m.eigenvalue * t;
    if ((complete = decay > DecayingSeries::negligible)) break;
    series.add(2 * m.amplitude * value(m, medium_, z) * std::exp(-decay) / (m.eigenvalue * m.norm));
  }
  const double jump = (p_.flux_after - p_.flux_before) / p_.upper.conductivity;
  return series.subtract_from(steady(p_.flux_after, z), jump * std::exp((medium_.length2 - z) / 2), complete,
                              "Srivastava-Yeh two layers");
}

double SrivastavaYehTwoLayerSolution::head(double z, double t) const {
  return std::log(relative_conductivity(z, t)) / p_.alpha;
}

double SrivastavaYehTwoLayerSolution::content(double z, double t) const {
  const SrivastavaYehTwoLayer::Layer& layer = z < 0 ? p_.lower : p_.upper;
  return layer.theta_r + range(layer) * relative_conductivity(z, t);
}

double SrivastavaYehTwoLayerSolution::flux(double z_metres, double t_seconds) const {
  require_inside(z_metres, t_seconds);
  const double z = p_.alpha * z_metres, t = time_scale_ * t_seconds;
  if (t == 0) return p_.flux_before;
  DecayingSeries series;
  bool complete = false;
  for (const TwoLayerMode& m : modes_) {
    const double decay = m.eigenvalue * t;
    if ((complete = decay > DecayingSeries::negligible)) break;
    series.add(2 * m.amplitude * carried(m, medium_, z) * std::exp(-decay) / (m.eigenvalue * m.norm));
  }
  return series.subtract_from(p_.flux_after, (p_.flux_after - p_.flux_before) * std::exp((medium_.length2 - z) / 2),
                              complete, "Srivastava-Yeh two layers, flux");
}

}  // namespace wetfront::verification::exact
