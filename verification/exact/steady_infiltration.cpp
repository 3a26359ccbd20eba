#include "verification/exact/steady_infiltration.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/exact/bisect.h"
#include "verification/exact/quadrature.h"
#include "verification/exact/validity.h"

namespace wetfront::verification::exact {
namespace {
constexpr double driest = 1e4;  // in 1/alpha: where K/Ks has fallen below 1e-10 for every n > 1.3
constexpr double linear_part = 1e-5;
constexpr double infinity = std::numeric_limits<double>::infinity();
}  // namespace

double SteadyGardner::head(double z) const {
  require_problem(alpha > 0 && conductivity > 0, "steady Gardner: alpha and Ks must be > 0");
  require_problem(flux <= conductivity && base_head <= 0, "steady Gardner: q <= Ks and base_head <= 0 are required");
  require_point(z >= 0, "steady Gardner: z < 0");
  const double q = flux / conductivity;
  // e^{ah0} - (1 - e^{-az})(e^{ah0} - q): keeps digits where h is near h0
  const double base = std::exp(alpha * base_head), change = std::expm1(-alpha * z) * (base - q);
  require_point(base + change > 0, "steady Gardner: evaporation cannot be drawn this high");
  return base_head + std::log1p(change / base) / alpha;
}

SteadyVanGenuchten::SteadyVanGenuchten(const VanGenuchten& soil, double flux, double base_head)
    : soil_(soil), flux_(flux), base_(base_head), limit_(-infinity), max_height_(infinity) {
  soil.validate();
  require_problem(flux < soil.conductivity && base_head <= 0,
                  "steady van Genuchten: q < Ks and base_head <= 0 are required");
  require_problem(soil.conductivity * soil.relative_conductivity(base_head) > flux,
                  "steady van Genuchten: K(base_head) must exceed q");
  if (flux > 0) limit_ = soil.head_of_conductivity(flux);
  if (flux < 0) max_height_ = height(base_head - driest / soil.alpha);
}

double SteadyVanGenuchten::height(double head) const {
  require_point(head > limit_ && head <= base_, "steady van Genuchten: no such head in this profile");
  if (head == base_) return 0;
  const auto conductivity = [&](double h) { return soil_.conductivity * soil_.relative_conductivity(h); };
  // Nearer to the limit than this K - q is too small a difference to integrate; there it is linear in h to 1e-5.
  const double linear = flux_ > 0 ? limit_ + linear_part * (base_ - limit_) : -infinity;
  const double end = std::max(head, linear);
  // From the base in ln(1 + suction): K has its root singularity at h = 0, and evaporation profiles run over decades.
  const double scale = 1 / soil_.alpha;
  const auto slope = [&](double u) {
    const double k = conductivity(base_ - scale * std::expm1(u));
    return k / (k - flux_) * scale * std::exp(u);
  };
  const double height = integrate(slope, 0, std::log1p((base_ - end) / scale), 1e-11);
  if (head >= linear) return height;
  const double steepness = (conductivity(linear) - flux_) / (linear - limit_);
  return height + flux_ / steepness * std::log((linear - limit_) / (head - limit_));
}

double SteadyVanGenuchten::head(double z) const {
  require_point(z >= 0 && z < max_height_, "steady van Genuchten: z outside the profile");
  if (z == 0) return base_;
  if (flux_ == 0) return base_ - z;  // hydrostatic
  if (flux_ < 0) return bisect([&](double h) { return height(h) < z; }, base_ - driest / soil_.alpha, base_);
  // Rain: h approaches the limit exponentially in z, so bisect in ln(h - limit).
  const double range = base_ - limit_;
  double low = -1;
  while (height(limit_ + range * std::exp(low)) < z) {
    if (low < -30) return limit_;  // nearer than 1e-13 of the range: the limit itself
    low -= 1;
  }
  const auto at = [&](double u) { return std::min(limit_ + range * std::exp(u), base_); };
  return at(bisect([&](double u) { return height(at(u)) < z; }, low, 0));
}

}  // namespace wetfront::verification::exact
