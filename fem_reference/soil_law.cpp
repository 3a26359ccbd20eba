#include "fem_reference/soil_law.h"

#include <cmath>

namespace wetfront::fem_reference {
namespace {

// Powers go through log/exp with log1p/expm1, so that neither end of the curve cancels:
// u = (alpha |psi|)^n, Se = (1 + u)^-m, 1 - Se^{1/m} = u / (1 + u).
struct VanGenuchtenPowers {
  VanGenuchtenPowers(const VanGenuchten& soil, double head)
      : m(1 - 1 / soil.n), log_u(soil.n * std::log(-soil.alpha * head)), u(std::exp(log_u)), log1p_u(std::log1p(u)) {}
  double m, log_u, u, log1p_u;
};

/// van Genuchten 1980, Eqs 3 and 21.
ValueAndSlope effective_saturation(const VanGenuchten& soil, double head) {
  const VanGenuchtenPowers p(soil, head);
  const double se = std::exp(-p.m * p.log1p_u);
  return {se, p.m * soil.n * se / ((1 + 1 / p.u) * -head)};
}

ValueAndSlope effective_saturation(const ExponentialRetention& soil, double head) {
  const double se = std::exp(soil.alpha * head);
  return {se, soil.alpha * se};
}

/// Mualem 1976 in van Genuchten's closed form (1980, Eq 8): Kr = Se^1/2 T^2, T = 1 - (u/(1+u))^m.
ValueAndSlope mualem(const VanGenuchten& soil, double head) {
  const VanGenuchtenPowers p(soil, head);
  const double log_ratio = -std::log1p(1 / p.u);  // log(u/(1+u))
  const double t = -std::expm1(p.m * log_ratio);
  const double kr = std::exp(-0.5 * p.m * p.log1p_u) * t * t;
  const double n_over_head = soil.n / head;  // d(log u)/dpsi
  // d(log Kr)/dpsi = -m [u/2 + 2 (1-T)/T] / (1+u) d(log u)/dpsi
  const double log_slope = -p.m * n_over_head * (0.5 / (1 + 1 / p.u) + 2 * (1 - t) / (t * (1 + p.u)));
  return {kr, kr * log_slope};
}

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};

}  // namespace

SoilLaw::SoilLaw(const Soil& soil)
    : soil_(soil),
      porosity_(soil.porosity > 0 ? soil.porosity
                                  : std::visit([](const auto& r) { return r.theta_s; }, soil.retention)) {}

ValueAndSlope SoilLaw::water_content(double head) const {
  return std::visit(
      [&](const auto& retention) -> ValueAndSlope {
        if (head >= 0) return {retention.theta_s, 0};
        const ValueAndSlope se = effective_saturation(retention, head);
        const double range = retention.theta_s - retention.theta_r;
        return {retention.theta_r + range * se.value, range * se.slope};
      },
      soil_.retention);
}

ValueAndSlope SoilLaw::storage(double head) const {
  ValueAndSlope theta = water_content(head);
  if (head > 0) {
    theta.value += soil_.specific_storage * head;
    theta.slope += soil_.specific_storage;
  }
  return theta;
}

ValueAndSlope SoilLaw::conductivity(double head) const {
  const double ks = soil_.saturated_conductivity;
  if (head >= 0) return {ks, 0};
  const ValueAndSlope kr = std::visit(Overloaded{[&](const MualemConductivity&) -> ValueAndSlope {
                                                   return mualem(std::get<VanGenuchten>(soil_.retention), head);
                                                 },
                                                 [&](const ExponentialConductivity& law) -> ValueAndSlope {
                                                   const double value = std::exp(law.alpha * head);
                                                   return {value, law.alpha * value};
                                                 },
                                                 [](const ConstantConductivity&) -> ValueAndSlope {
                                                   return {1, 0};
                                                 }},
                                      soil_.conductivity);
  return {ks * kr.value, ks * kr.slope};
}

}  // namespace wetfront::fem_reference
