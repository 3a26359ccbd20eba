#include "fem_reference/soil/conductivity_integral.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wetfront::fem_reference {
namespace {

constexpr double unit = 1e-3;    // m
constexpr double driest = -1e6;  // m; drier than any soil
constexpr int intervals = 4096;
const double width = std::log1p(-driest / unit) / intervals;
constexpr double least = 1e-280;  // K of a law that underflows; its logarithm is taken

double head_at(double x) {
  return -unit * std::expm1(x);
}

}  // namespace

ConductivityIntegral::ConductivityIntegral(const std::function<double(double)>& conductivity)
    : saturated_(conductivity(0)), logarithm_(intervals + 1), slope_(intervals + 1) {
  // Gauss' four points on [0, 1].
  const std::array<double, 4> at{0.069431844202973712, 0.330009478207571868, 0.669990521792428132,
                                 0.930568155797026288};
  const std::array<double, 4> weight{0.173927422568726929, 0.326072577431273071, 0.326072577431273071,
                                     0.173927422568726929};
  const auto integrand = [&](double x) {  // - dPhi/dx
    return std::max(least, conductivity(head_at(x))) * unit * std::exp(x);
  };
  double sum = integrand(width * intervals);  // below the driest head as if K fell like 1/suction squared
  for (int i = intervals; i >= 0; --i) {
    logarithm_[i] = std::log(sum);
    slope_[i] = -width * integrand(width * i) / sum;
    for (std::size_t q = 0; q < at.size() && i > 0; ++q) sum += width * weight[q] * integrand(width * (i - 1 + at[q]));
  }
}

ValueAndSlope ConductivityIntegral::operator()(double head) const {
  if (head >= 0) return {std::exp(logarithm_[0]) + saturated_ * head, saturated_};
  const double x = std::min(std::log1p(-head / unit) / width, intervals - 1e-9);
  const auto i = static_cast<std::size_t>(x);
  const double t = x - static_cast<double>(i);
  const double secant = logarithm_[i + 1] - logarithm_[i], left = slope_[i], right = slope_[i + 1];
  const double c2 = 3 * secant - 2 * left - right, c3 = left + right - 2 * secant;
  const double value = std::exp(logarithm_[i] + t * (left + t * (c2 + t * c3)));
  return {value, -value * (left + t * (2 * c2 + 3 * t * c3)) / (width * (unit - head))};
}

}  // namespace wetfront::fem_reference
