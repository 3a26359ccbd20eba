#include "verification/exact/manufactured.h"

#include "verification/exact/validity.h"

#include <cmath>

namespace wetfront::verification::exact {
namespace {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector times(const std::array<double, 6>& t, const Vector& v) {
  return {t[0] * v[0] + t[3] * v[1] + t[5] * v[2], t[3] * v[0] + t[1] * v[1] + t[4] * v[2],
          t[5] * v[0] + t[4] * v[1] + t[2] * v[2]};
}

}  // namespace

ManufacturedSolution::ManufacturedSolution(const Manufactured& problem) : p_(problem) {
  double highest = p_.mean;
  for (const auto& wave : p_.waves) highest += std::abs(wave.amplitude);
  require_problem(highest < 0, "manufactured: mean + sum |amplitude| must be < 0 (unsaturated everywhere)");
  if (const auto* soil = std::get_if<VanGenuchten>(&p_.soil)) soil->validate();
}

double ManufacturedSolution::head(const Point& at, double t) const {
  double head = p_.mean;
  for (const auto& wave : p_.waves)
    head += wave.amplitude * std::sin(dot(wave.wave_vector, at) + wave.frequency * t + wave.phase);
  return head;
}

/// van Genuchten with s = (-alpha h)^n, ds/dh = n s/h: Se = (1 + s)^-m, and in Mualem's K the bracket is
/// B = 1 - (s/(1 + s))^m, since 1 - Se^{1/m} = s/(1 + s).
ManufacturedSolution::Law ManufacturedSolution::law(double head) const {
  if (const auto* gardner = std::get_if<ManufacturedGardner>(&p_.soil)) {
    const double e = std::exp(gardner->alpha * head), k = gardner->conductivity * e;
    return {(gardner->theta_s - gardner->theta_r) * gardner->alpha * e, k, gardner->alpha * k};
  }
  const auto& soil = std::get<VanGenuchten>(p_.soil);
  const double m = 1 - 1 / soil.n, s = std::pow(-soil.alpha * head, soil.n), ds = soil.n * s / head;
  const double se = std::pow(1 + s, -m), dse = -m * se / (1 + s) * ds;
  const double ratio = s / (1 + s), power = std::pow(ratio, m), bracket = 1 - power;
  const double dbracket = -m * power / ratio * ds / ((1 + s) * (1 + s));
  const double root = std::sqrt(se), ks = soil.conductivity;
  return {(soil.theta_s - soil.theta_r) * dse, ks * root * bracket * bracket,
          ks * (0.5 * dse / root * bracket * bracket + 2 * root * bracket * dbracket)};
}

double ManufacturedSolution::content(double head) const {
  if (const auto* gardner = std::get_if<ManufacturedGardner>(&p_.soil))
    return gardner->theta_r + (gardner->theta_s - gardner->theta_r) * std::exp(gardner->alpha * head);
  return std::get<VanGenuchten>(p_.soil).content(head);
}

double ManufacturedSolution::conductivity(double head) const {
  return law(head).conductivity;
}

double ManufacturedSolution::source(const Point& at, double t) const {
  double rate = 0, curvature = 0;  // psi_t, T : grad grad psi
  Vector gradient{};
  for (const auto& wave : p_.waves) {
    const double angle = dot(wave.wave_vector, at) + wave.frequency * t + wave.phase;
    const double sine = wave.amplitude * std::sin(angle), cosine = wave.amplitude * std::cos(angle);
    rate += wave.frequency * cosine;
    curvature -= sine * dot(wave.wave_vector, times(p_.anisotropy, wave.wave_vector));
    for (int axis = 0; axis < 3; ++axis) gradient[axis] += cosine * wave.wave_vector[axis];
  }
  const Law now = law(head(at, t));
  const Vector drive{gradient[0] - p_.gravity[0], gradient[1] - p_.gravity[1], gradient[2] - p_.gravity[2]};
  return now.capacity * rate - now.slope * dot(gradient, times(p_.anisotropy, drive)) - now.conductivity * curvature;
}

}  // namespace wetfront::verification::exact
