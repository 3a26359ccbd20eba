#include "verification/exact/granular_collapse.h"

#include <algorithm>
#include <cmath>

#include "verification/exact/validity.h"

namespace wetfront::verification::exact {
namespace {

constexpr double low = 1.8, tall = 2.8;

double plane_run_out(double aspect) {
  require_problem(aspect > 0, "collapse: the aspect ratio must be > 0");
  const auto above = [](double a) { return 1.9 * std::cbrt(a * a); };
  if (aspect <= low) return 1.2 * aspect;
  if (aspect >= tall) return above(aspect);
  return 1.2 * low + (aspect - low) / (tall - low) * (above(tall) - 1.2 * low);
}

}  // namespace

Collapse lube_plane(double aspect) {
  return {plane_run_out(aspect), aspect <= 1.15 ? aspect : std::min(aspect, std::pow(aspect, 0.4))};
}

Collapse lajeunesse_plane(double aspect) {
  return {plane_run_out(aspect), aspect < 0.7 ? aspect : std::cbrt(aspect)};
}

Collapse lube_axisymmetric(double aspect) {
  require_problem(aspect > 0, "collapse: the aspect ratio must be > 0");
  const double run_out = aspect < 1.7 ? 1.24 * aspect : 1.6 * std::sqrt(aspect);
  return {run_out, std::min(aspect, 0.88 * std::pow(aspect, 1.0 / 6))};
}

}  // namespace wetfront::verification::exact
