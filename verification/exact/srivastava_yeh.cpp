#include "verification/exact/srivastava_yeh.h"

#include <cmath>
#include <numbers>

namespace wetfront::verification::exact {
namespace {

constexpr double negligible = 46;  // exp(-46) = 1e-20, below the rounding of the sum

/// Root of sin(lambda L) + 2 lambda cos(lambda L) with lambda L in ((k - 1/2) pi, k pi), by bisection.
double root(int k, double length) {
  const auto f = [&](double lambda) { return std::sin(lambda * length) + 2 * lambda * std::cos(lambda * length); };
  double low = (k - 0.5) * std::numbers::pi / length, high = k * std::numbers::pi / length;
  const bool low_is_positive = f(low) > 0;
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    ((f(middle) > 0) == low_is_positive ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

SrivastavaYehSolution::SrivastavaYehSolution(const SrivastavaYeh& problem, int terms)
    : p_(problem),
      length_(problem.alpha * problem.thickness),
      before_(problem.flux_before / problem.conductivity),
      after_(problem.flux_after / problem.conductivity),
      time_scale_(problem.alpha * problem.conductivity / (problem.theta_s - problem.theta_r)) {
  for (int k = 1; k <= terms; ++k) roots_.push_back(root(k, length_));
}

double SrivastavaYehSolution::steady(double flux, double z) const {
  return flux - (flux - std::exp(p_.alpha * p_.base_head)) * std::exp(-z);
}

double SrivastavaYehSolution::head(double z_metres, double t_seconds) const {
  const double z = p_.alpha * z_metres, t = time_scale_ * t_seconds;
  if (t == 0) return std::log(steady(before_, z)) / p_.alpha;
  double sum = 0;
  for (double lambda : roots_) {
    const double decay = lambda * lambda * t;
    if (decay > negligible) break;
    sum += std::sin(lambda * z) * std::sin(lambda * length_) * std::exp(-decay) /
           (1 + length_ / 2 + 2 * lambda * lambda * length_);
  }
  const double k = steady(after_, z) - 4 * (after_ - before_) * std::exp((length_ - z) / 2 - t / 4) * sum;
  return std::log(k) / p_.alpha;
}

double SrivastavaYehSolution::water_table_flux(double t_seconds) const {
  const double t = time_scale_ * t_seconds;
  if (t == 0) return p_.flux_before;
  double sum = 0;
  for (double lambda : roots_) {
    const double decay = lambda * lambda * t;
    if (decay > negligible) break;
    sum += lambda * std::sin(lambda * length_) * std::exp(-decay) / (1 + length_ / 2 + 2 * lambda * lambda * length_);
  }
  return p_.conductivity * (after_ - 4 * (after_ - before_) * std::exp(length_ / 2 - t / 4) * sum);
}

}  // namespace wetfront::verification::exact
