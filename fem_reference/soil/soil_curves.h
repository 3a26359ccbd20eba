#pragma once

#include "fem_reference/richards_problem.h"

#include <cmath>

namespace wetfront::fem_reference {

/// A function of pressure head and its derivative with respect to it.
struct ValueAndSlope {
  double value = 0;
  double slope = 0;
};

/// Effective saturation Se(psi) [-] and dSe/dpsi [1/m] of the printed laws for psi < 0 (van Genuchten's without its
/// cut-off, HaverkampLog's for psi < -entry). Formulas and sources: richards_problem.h.
inline ValueAndSlope effective_saturation(const VanGenuchten& law, double head);
ValueAndSlope effective_saturation(const ExponentialRetention& law, double head);
ValueAndSlope effective_saturation(const HaverkampRetention& law, double head);
ValueAndSlope effective_saturation(const HaverkampLogRetention& law, double head);
ValueAndSlope effective_saturation(const BroadbridgeWhiteRetention& law, double head);

/// K/Ks [-] and its derivative [1/m] for psi < 0.
inline ValueAndSlope mualem(const VanGenuchten& law, double head);
ValueAndSlope relative_conductivity(const HaverkampConductivity& law, double head);
ValueAndSlope broadbridge_white(const BroadbridgeWhiteRetention& law, double head);

// Inline: these two are most of the cost of a run.

// Powers go through log/exp with log1p/expm1, so that neither end of the curve cancels:
// u = (alpha |psi|)^n, Se = (1 + u)^-m, 1 - Se^{1/m} = u / (1 + u).
struct VanGenuchtenPowers {
  VanGenuchtenPowers(const VanGenuchten& soil, double head)
      : m(1 - 1 / soil.n), log_u(soil.n * std::log(-soil.alpha * head)), u(std::exp(log_u)), log1p_u(std::log1p(u)) {}
  double m, log_u, u, log1p_u;
};

/// van Genuchten 1980, Eqs 3 and 21.
inline ValueAndSlope effective_saturation(const VanGenuchten& soil, double head) {
  const VanGenuchtenPowers p(soil, head);
  const double se = std::exp(-p.m * p.log1p_u);
  return {se, p.m * soil.n * se / ((1 + 1 / p.u) * -head)};
}

/// Mualem 1976 in van Genuchten's closed form (1980, Eq 8): Kr = Se^1/2 T^2, T = 1 - (u/(1+u))^m.
inline ValueAndSlope mualem(const VanGenuchten& soil, double head) {
  const VanGenuchtenPowers p(soil, head);
  const double log_ratio = -std::log1p(1 / p.u);  // log(u/(1+u))
  const double t = -std::expm1(p.m * log_ratio);
  const double kr = std::exp(-0.5 * p.m * p.log1p_u) * t * t;
  const double n_over_head = soil.n / head;  // d(log u)/dpsi
  // d(log Kr)/dpsi = -m [u/2 + 2 (1-T)/T] / (1+u) d(log u)/dpsi
  const double log_slope = -p.m * n_over_head * (0.5 / (1 + 1 / p.u) + 2 * (1 - t) / (t * (1 + p.u)));
  return {kr, kr * log_slope};
}

}  // namespace wetfront::fem_reference
