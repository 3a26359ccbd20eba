#include "fem_reference/soil/skeleton_storage.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wetfront::fem_reference {
namespace {

constexpr double unit = 1e-3;    // m: suctions below it are spaced evenly, others by their logarithm
constexpr int intervals = 4096;  // 0.4 % of suction each: cubics are then off by 1e-12
const double width = std::log1p(-SkeletonStorage::driest_head / unit) / intervals;

}  // namespace

SkeletonStorage::SkeletonStorage(double full, const std::function<double(double)>& rate,
                                 const std::function<double(double)>& capacity)
    : full_(full), rate_full_(rate(full)), limit_(driest_head), value_{0}, slope_{-unit * rate_full_} {
  const auto head = [&](double x) { return full_ - unit * std::expm1(x); };
  const auto integrand = [&](double x) { return -unit * std::exp(x) * rate(head(x)); };  // d/dx
  // Gauss' four points on [0, 1].
  const std::array<double, 4> at{0.069431844202973712, 0.330009478207571868, 0.669990521792428132,
                                 0.930568155797026288};
  const std::array<double, 4> weight{0.173927422568726929, 0.326072577431273071, 0.326072577431273071,
                                     0.173927422568726929};
  for (int i = 0; i < intervals; ++i) {
    double sum = 0;
    for (std::size_t q = 0; q < at.size(); ++q) sum += width * weight[q] * integrand(width * (i + at[q]));
    const double next = head(width * (i + 1));
    if (rate(next) + capacity(next) < 0) {
      limit_ = head(width * i);
      break;
    }
    value_.push_back(value_.back() + sum);
    slope_.push_back(integrand(width * (i + 1)));
  }
}

ValueAndSlope SkeletonStorage::operator()(double head) const {
  if (head >= full_) return {rate_full_ * head, rate_full_};
  const double offset = rate_full_ * full_;  // the integral is from 0, the table from `full`
  const double x = std::log1p((full_ - head) / unit);
  const auto i = static_cast<std::size_t>(x / width);
  if (i + 1 >= value_.size()) return {offset + value_.back(), 0};
  const double t = x / width - static_cast<double>(i);
  const double secant = value_[i + 1] - value_[i], left = width * slope_[i], right = width * slope_[i + 1];
  const double c2 = 3 * secant - 2 * left - right, c3 = left + right - 2 * secant;
  const double dx_dhead = -1 / (unit + full_ - head);
  return {offset + value_[i] + t * (left + t * (c2 + t * c3)), (left + t * (2 * c2 + 3 * t * c3)) / width * dx_dhead};
}

}  // namespace wetfront::fem_reference
