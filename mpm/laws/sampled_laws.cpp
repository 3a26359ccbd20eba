#include "mpm/laws/sampled_laws.h"

#include "mpm/laws/monotone_points.h"
#include "mpm/laws/relative_permeability.h"

#include <cmath>

namespace wetfront::mpm {

namespace {

ValueAndSlope effective_of(const VanGenuchten& curve, double s) {
  return {curve.effective(s), curve.effective_slope(s)};
}

SampledLaw scaled_to_one_at(double cut_off, std::function<ValueAndSlope(double)> law) {
  if (!(cut_off > 0)) return {1, 0, std::move(law)};
  const double at_cut_off = law(cut_off).value;
  return {1, cut_off, [law = std::move(law), at_cut_off](double s) {
            const ValueAndSlope full = law(s);
            return ValueAndSlope{full.value / at_cut_off, full.slope / at_cut_off};
          }};
}

/// Se = a/(a + g) and its slope, for a rising g(s).
ValueAndSlope hyperbola(double a, double g, double g_slope) {
  const double value = a / (a + g);
  return {value, -value * value * g_slope / a};
}

/// Se of Broadbridge & White: with v = 1/Se - 1 the curve is s/scale = v + ln(1 + c v/(c-1))/c, concave in v, so that
/// Newton's method from v = 0 climbs to the root without passing it.
ValueAndSlope broadbridge_white(const BroadbridgeWhiteRetention& spec, double s) {
  const double c = spec.c, target = s / spec.suction_scale;
  double v = 0, slope = 1;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double rise = c / (c - 1) * v;
    slope = 1 + 1 / ((c - 1) * (1 + rise));
    const double change = (target - v - std::log1p(rise) / c) / slope;
    v += change;
    if (std::abs(change) <= 1e-15 * v) break;
  }
  slope = 1 + 1 / ((c - 1) + c * v);
  const double value = 1 / (1 + v);
  return {value, -value * value / (slope * spec.suction_scale)};
}

SampledRetention retention_of(const VanGenuchtenRetention& spec) {
  const VanGenuchten curve(spec);
  return {scaled_to_one_at(spec.cut_off, [curve](double s) { return effective_of(curve, s); }), spec.s_min, spec.s_max,
          spec.air_entry};
}
SampledRetention retention_of(const ExponentialRetention& spec) {
  const ExponentialCurve curve(spec);
  return {{1, 0,
           [curve](double s) {
             return ValueAndSlope{curve.effective(s), curve.effective_slope(s)};
           }},
          spec.s_min,
          spec.s_max,
          spec.suction_scale};
}
SampledRetention retention_of(const HaverkampRetention& spec) {
  const auto law = [spec](double s) {
    const double g = std::pow(s, spec.beta);
    return hyperbola(spec.a, g, spec.beta * g / s);
  };
  return {{1, 0, law}, spec.s_min, spec.s_max, std::pow(spec.a, 1 / spec.beta)};
}
SampledRetention retention_of(const HaverkampLogRetention& spec) {
  const auto law = [spec](double s) {
    const double logarithm = std::log(s / spec.entry), g = std::pow(logarithm, spec.beta);
    return hyperbola(spec.a, g, spec.beta * g / (logarithm * s));
  };
  return {{1, spec.entry, law}, spec.s_min, spec.s_max, spec.entry * std::exp(std::pow(spec.a, 1 / spec.beta))};
}
SampledRetention retention_of(const BroadbridgeWhiteRetention& spec) {
  return {{1, 0, [spec](double s) { return broadbridge_white(spec, s); }}, spec.s_min, spec.s_max, spec.suction_scale};
}
SampledRetention retention_of(const PointsRetention& spec) {
  const double top = spec.saturation.front(), range = top - spec.saturation.back();
  const MonotonePoints points(spec.suction, spec.saturation);
  const auto law = [points, bottom = spec.saturation.back(), range](double s) {
    const ValueAndSlope saturation = points.at(s);
    return ValueAndSlope{(saturation.value - bottom) / range, saturation.slope / range};
  };
  double scale = spec.suction.back();
  for (std::size_t k = spec.suction.size(); k-- > 0;)
    if (spec.saturation[k] < top - 0.5 * range) scale = spec.suction[k];
  return {{1, points.plateau(), law}, spec.saturation.back(), top, scale};
}

template <class Law>
SampledLaw mualem_like(const Soil& soil, const Law& law) {
  const auto* spec = std::get_if<VanGenuchtenRetention>(&*soil.retention);
  if (spec == nullptr)
    throw CannotPlan("soil '" + soil.name + "' (" + soil.origin +
                     "): Mualem's permeability is a closed form of the van Genuchten curve only, and this soil has "
                     "another retention curve. Use another permeability law");
  const VanGenuchten curve(*spec);
  SampledLaw result = scaled_to_one_at(spec->cut_off, [law, curve](double s) { return law(curve, s); });
  // Fed with S, S_max < 1, Mualem's formula stays below 1 at saturation: the limit, so that k does not jump there.
  if (!(spec->cut_off > 0)) result.top = law(curve, 1e-12 * spec->air_entry).value;
  return result;
}

SampledLaw permeability_of(const Soil& soil, const MualemPermeability&) {
  return mualem_like(soil, Mualem{});
}
SampledLaw permeability_of(const Soil& soil, const PrintedMualemPermeability&) {
  return mualem_like(soil, PrintedMualem{});
}
SampledLaw permeability_of(const Soil& soil, const MualemOfSaturationPermeability&) {
  return mualem_like(soil, MualemOfSaturation{});
}
SampledLaw permeability_of(const Soil&, const ExponentialPermeability& spec) {
  return {1, 0, [scale = spec.suction_scale](double s) {
            const double value = std::exp(-s / scale);
            return ValueAndSlope{value, -value / scale};
          }};
}
SampledLaw permeability_of(const Soil&, const ConstantPermeability&) {
  return {1, 0, [](double) { return ValueAndSlope{}; }};
}
SampledLaw permeability_of(const Soil&, const HaverkampPermeability& spec) {
  return {1, 0, [spec](double s) {
            const double g = std::pow(s, spec.gamma);
            return hyperbola(spec.a, g, spec.gamma * g / s);
          }};
}
SampledLaw permeability_of(const Soil& soil, const BroadbridgeWhitePermeability&) {
  const auto* spec = std::get_if<BroadbridgeWhiteRetention>(&*soil.retention);
  if (spec == nullptr)
    throw CannotPlan("soil '" + soil.name + "' (" + soil.origin +
                     "): the permeability of Broadbridge and White belongs to their retention curve, and this soil "
                     "has another one. Use that curve, or another permeability law");
  return {1, 0, [spec = *spec](double s) {
            const ValueAndSlope se = broadbridge_white(spec, s);
            const double c = spec.c, rest = c - se.value;
            return ValueAndSlope{(c - 1) * se.value * se.value / rest,
                                 (c - 1) * se.value * (2 * c - se.value) / (rest * rest) * se.slope};
          }};
}
SampledLaw permeability_of(const Soil&, const PointsPermeability& spec) {
  std::vector<double> logarithm;
  for (double relative : spec.relative) logarithm.push_back(std::log(relative));
  const MonotonePoints points(spec.suction, logarithm);
  return {1, points.plateau(), [points](double s) {
            const ValueAndSlope log_k = points.at(s);
            const double value = std::exp(log_k.value);
            return ValueAndSlope{value, value * log_k.slope};
          }};
}

}  // namespace

SampledRetention sampled_retention(const RetentionSpec& spec) {
  return std::visit([](const auto& law) { return retention_of(law); }, spec);
}

SampledLaw sampled_permeability(const Soil& soil) {
  return std::visit([&soil](const auto& law) { return permeability_of(soil, law); }, *soil.permeability);
}

}  // namespace wetfront::mpm
