#include "fem_reference/soil/soil_curves.h"

#include <algorithm>
#include <cmath>

namespace wetfront::fem_reference {
namespace {

/// a / (a + x^p) and its derivative with respect to x, for x >= 0; 1/u keeps both ends finite.
ValueAndSlope rational_decay(double a, double power, double x) {
  const double u = std::exp(power * std::log(x)) / a;
  const double value = 1 / (1 + u);
  return {value, x > 0 ? -power / x * value / (1 + 1 / u) : 0};
}

}  // namespace

ValueAndSlope effective_saturation(const ExponentialRetention& soil, double head) {
  const double se = std::exp(soil.alpha * head);
  return {se, soil.alpha * se};
}

ValueAndSlope effective_saturation(const HaverkampRetention& soil, double head) {
  const ValueAndSlope se = rational_decay(soil.a, soil.beta, -head);
  return {se.value, -se.slope};
}

ValueAndSlope effective_saturation(const HaverkampLogRetention& soil, double head) {
  const ValueAndSlope se = rational_decay(soil.a, soil.beta, std::log(-head / soil.entry));
  return {se.value, se.slope / head};
}

/// With v = 1/Se the law reads f(v) = 1 - v - ln[(c v - 1)/(c - 1)]/c = psi/lambda, convex and falling for v >= 1, so
/// Newton converges from everywhere. dSe/dpsi = Se^2 (c - Se) / (c lambda).
ValueAndSlope effective_saturation(const BroadbridgeWhiteRetention& soil, double head) {
  const double target = head / soil.lambda;
  double v = 1 - target;
  for (int i = 0; i < 50; ++i) {
    const double f = 1 - v - std::log((soil.c * v - 1) / (soil.c - 1)) / soil.c;
    const double next = std::max(1.0, v + (f - target) / (1 + 1 / (soil.c * v - 1)));
    const bool done = std::abs(next - v) <= 1e-15 * v;
    v = next;
    if (done) break;
  }
  const double se = 1 / v;
  return {se, se * se * (soil.c - se) / (soil.c * soil.lambda)};
}

ValueAndSlope relative_conductivity(const HaverkampConductivity& law, double head) {
  const ValueAndSlope kr = rational_decay(law.a, law.gamma, -head);
  return {kr.value, -kr.slope};
}

ValueAndSlope broadbridge_white(const BroadbridgeWhiteRetention& soil, double head) {
  const ValueAndSlope se = effective_saturation(soil, head);
  const double rest = soil.c - se.value;
  const double kr = (soil.c - 1) * se.value * se.value / rest;
  return {kr, (soil.c - 1) * se.value * (2 * soil.c - se.value) / (rest * rest) * se.slope};
}

}  // namespace wetfront::fem_reference
