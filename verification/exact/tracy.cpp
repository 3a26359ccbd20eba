#include "verification/exact/tracy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "verification/exact/series.h"
#include "verification/exact/validity.h"

namespace wetfront::verification::exact {
namespace {
using std::numbers::pi;
}

TracySolution::TracySolution(const Tracy& problem, int terms)
    : p_(problem),
      terms_(terms),
      dry_(std::exp(problem.alpha * problem.dry_head)),
      rise_(-std::expm1(problem.alpha * problem.dry_head)),
      c_(problem.alpha * (problem.theta_s - problem.theta_r) / problem.conductivity) {
  require_problem(p_.alpha > 0 && p_.conductivity > 0 && p_.width > 0 && p_.height > 0 && p_.depth_y >= 0,
                  "Tracy: alpha, Ks and the box must be > 0");
  require_problem(p_.theta_s > p_.theta_r, "Tracy: theta_s must exceed theta_r");
  require_problem(p_.dry_head < 0, "Tracy: dry_head must be < 0");
  require_problem(terms >= 1, "Tracy: at least one term");
  const bool solid = p_.depth_y > 0;
  if (p_.sides == Tracy::Sides::specified) {
    modes_ = {{1, pi / p_.width, solid ? pi / p_.depth_y : 0}};
    return;
  }
  const double kx = 2 * pi / p_.width;
  modes_ = {{0.5, 0, 0}, {-0.5, kx, 0}};
  if (!solid) return;
  const double ky = 2 * pi / p_.depth_y;
  modes_ = {{0.25, 0, 0}, {-0.25, kx, 0}, {-0.25, 0, ky}, {0.25, kx, ky}};
}

double TracySolution::lateral(const LateralMode& m, double x, double y) const {
  if (p_.sides == Tracy::Sides::closed) return m.weight * std::cos(m.kx * x) * std::cos(m.ky * y);
  return m.weight * std::sin(m.kx * x) * (m.ky > 0 ? std::sin(m.ky * y) : 1);
}

/// T(kappa^2; z, t). `background` is what H will be added to: accuracy is asked of the sum.
double TracySolution::vertical(double kappa_squared, double z, double t, double background) const {
  const double b2 = p_.alpha * p_.alpha / 4 + kappa_squared, b = std::sqrt(b2);
  const double lift = std::exp(p_.alpha * (p_.height - z) / 2);
  // sinh(b z)/sinh(b L) without overflow
  const double steady = lift * std::exp(b * (z - p_.height)) * std::expm1(-2 * b * z) / std::expm1(-2 * b * p_.height);
  DecayingSeries series;
  bool complete = std::isinf(t);
  for (int k = 1; k <= terms_ && !complete; ++k) {
    const double l = k * pi / p_.height, g = (b2 + l * l) / c_, decay = g * t;
    if ((complete = decay > DecayingSeries::negligible)) break;
    series.add((k % 2 == 0 ? 1 : -1) * l / g * std::sin(l * z) * std::exp(-decay));
  }
  const double shift = background / rise_;
  return series.subtract_from(steady + shift, -2 * lift / (p_.height * c_), complete, "Tracy") - shift;
}

double TracySolution::head(double x, double y, double z, double t) const {
  require_point(t >= 0, "Tracy: t < 0");
  const double slack = 1e-12 * p_.height;  // coordinates formed by sums
  require_point(x >= -slack && x <= p_.width + slack && z >= -slack && z <= p_.height + slack &&
                    (p_.depth_y == 0 || (y >= -slack && y <= p_.depth_y + slack)),
                "Tracy: the point is outside the box");
  if (t == 0) return p_.dry_head;
  double rise = 0;
  for (const LateralMode& m : modes_)
    rise += lateral(m, x, y) * vertical(m.kx * m.kx + m.ky * m.ky, std::max(z, 0.0), t, dry_);
  return std::log(dry_ + rise_ * rise) / p_.alpha;
}

double TracySolution::steady_head(double x, double y, double z) const {
  return head(x, y, z, std::numeric_limits<double>::infinity());
}

}  // namespace wetfront::verification::exact
