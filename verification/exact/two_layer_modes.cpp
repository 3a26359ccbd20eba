#include "verification/exact/two_layer_modes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/exact/bisect.h"

namespace wetfront::verification::exact {
namespace {

using std::numbers::pi;

/// (u, u') -> angle in the branch that began at `start`: u'' = -m^2 u passes u = 0 only upwards in angle.
double advance(double m_squared, double length, double start) {
  const double branch = std::floor(start / pi), inside = start - branch * pi;
  const double sine = std::max(std::sin(inside), 0.0);  // rounding may put `inside` a bit above pi: still this branch
  if (m_squared > 0) {
    const double m = std::sqrt(m_squared);
    const double phase = branch * pi + std::atan2(m * sine, std::cos(inside)) + m * length;
    const double turns = std::floor(phase / pi), rest = phase - turns * pi;
    return turns * pi + std::atan2(std::max(std::sin(rest), 0.0), m * std::cos(rest));
  }
  const double s = sine_over(m_squared, length), c = cosine(m_squared, length);
  const double u = sine * c + std::cos(inside) * s;
  const double slope = std::cos(inside) * c - m_squared * sine * s;
  // Non-oscillating: at most one zero, so u < 0 means exactly one was passed.
  return u >= 0 ? branch * pi + std::atan2(u, slope) : (branch + 1) * pi + std::atan2(-u, -slope);
}

TwoLayerMode mode(const TwoLayerMedium& m, double eigenvalue) {
  const double l2 = eigenvalue - 0.25, mu2 = m.beta * eigenvalue - 0.25;
  const double s1 = sine_over(l2, m.length1), c1 = cosine(l2, m.length1);
  const double s2 = sine_over(mu2, m.length2), c2 = cosine(mu2, m.length2);
  // u and the flux Ks (u' + u/2) at the interface both give A, but either may read 0 = A 0: take both, least squares.
  const double value = s2 + 2 * c2, flux = 2 * m.beta * eigenvalue * s2;  // 1 + 4 mu^2 = 4 beta Lambda
  const double below = m.ratio * (c1 + s1 / 2), weight = 1 / (1 + std::abs(mu2));
  const double a = (s1 * value + weight * below * flux) / (value * value + weight * flux * flux);
  const double upper = integral_of_sine_squared(mu2, m.length2) + 2 * s2 * s2 + 2 * (m.length2 + s2 * c2);
  return {eigenvalue, l2, mu2, a, m.ratio * integral_of_sine_squared(l2, m.length1) + m.beta * a * a * upper};
}

}  // namespace

double sine_over(double y, double x) {
  if (std::abs(y) * x * x < 1e-8) return x * (1 - y * x * x / 6);  // next term (y x^2)^2/120 < 1e-18
  const double m = std::sqrt(std::abs(y));
  return (y > 0 ? std::sin(m * x) : std::sinh(m * x)) / m;
}

double cosine(double y, double x) {
  const double m = std::sqrt(std::abs(y));
  return y > 0 ? std::cos(m * x) : std::cosh(m * x);
}

double integral_of_sine_squared(double y, double x) {
  const double q = y * x * x;
  // Taylor below 1e-3: its next term is q^4 4e-5 = 4e-17; above, the difference loses at most 3 digits.
  if (std::abs(q) < 1e-3) return x * x * x * (1.0 / 3 - q / 15 + 2 * q * q / 315 - q * q * q / 2835);
  return (x - sine_over(y, x) * cosine(y, x)) / (2 * y);
}

double pruefer_angle(const TwoLayerMedium& m, double eigenvalue) {
  const double lower = advance(eigenvalue - 0.25, m.length1, 0);
  const double branch = std::floor(lower / pi), inside = lower - branch * pi;
  const double u = std::max(std::sin(inside), 0.0), slope = m.ratio * (std::cos(inside) + u / 2) - u / 2;
  return advance(m.beta * eigenvalue - 0.25, m.length2, branch * pi + std::atan2(u, slope));
}

double characteristic(const TwoLayerMedium& m, double eigenvalue) {
  const double l2 = eigenvalue - 0.25, mu2 = m.beta * eigenvalue - 0.25;
  const double s1 = sine_over(l2, m.length1), s2 = sine_over(mu2, m.length2);
  return (s1 + 2 * cosine(l2, m.length1)) * (s2 + 2 * cosine(mu2, m.length2)) - (1 + 4 * mu2) * s1 * s2 / m.ratio;
}

std::vector<TwoLayerMode> two_layer_modes(const TwoLayerMedium& medium, int count) {
  std::vector<TwoLayerMode> modes;
  double low = 0;
  for (int n = 0; n < count; ++n) {
    const double target = pi - std::atan(2.0) + n * pi;
    const auto past = [&](double eigenvalue) { return pruefer_angle(medium, eigenvalue) > target; };
    double high = std::max(2 * low, 1e-3);
    while (!past(high)) high *= 2;
    const double eigenvalue = bisect(past, low, high);
    modes.push_back(mode(medium, eigenvalue));
    low = eigenvalue;
  }
  return modes;
}

}  // namespace wetfront::verification::exact
