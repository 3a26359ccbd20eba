#include "mpm/laws/log_table.h"

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {

double LogTable::left_end(std::size_t index) const {
  if (index == 0) return 0;
  return std::bit_cast<double>(((first_pattern_ >> shift) + index - 1) << shift);
}

void LogTable::fit(std::size_t index, double width, const ValueAndSlope& left, const ValueAndSlope& right) {
  const double rise = (right.value - left.value) / width;
  double* c = &coefficients_[4 * index];
  c[0] = left.value;
  c[1] = left.slope;
  c[2] = (3 * rise - 2 * left.slope - right.slope) / width;
  c[3] = (left.slope + right.slope - 2 * rise) / (width * width);
}

LogTable::LogTable(const SampledLaw& law, int first_exponent) : top_(law.top), origin_(law.origin) {
  first_pattern_ = std::bit_cast<std::uint64_t>(std::ldexp(1.0, first_exponent));
  pieces_ = static_cast<std::size_t>((last_exponent - first_exponent) << bits) + 1;
  coefficients_.assign(4 * (pieces_ + 1), 0.0);
  integrals_.assign(pieces_ + 1, 0.0);
  // The law's slope just beyond its origin; 0 where it is so steep that a cubic with it would not be monotone.
  const double first = left_end(1);
  ValueAndSlope left{top_, law.at(origin_ + 1e-9 * (first + origin_)).slope};
  if (std::abs(left.slope) * first > 3 * std::abs(law.at(origin_ + first).value - top_)) left.slope = 0;
  for (std::size_t k = 0; k < pieces_; ++k) {
    ValueAndSlope right = law.at(origin_ + left_end(k + 1));
    if (k + 1 == pieces_) right.slope = 0;
    fit(k, left_end(k + 1) - left_end(k), left, right);
    left = right;
  }
  coefficients_[4 * pieces_] = left.value;
  for (std::size_t k = pieces_; k-- > 0;) {
    const double* c = &coefficients_[4 * k];
    const double d = left_end(k + 1) - left_end(k);
    integrals_[k] = integrals_[k + 1] + d * (c[0] + d * (c[1] / 2 + d * (c[2] / 3 + d * c[3] / 4)));
  }
}

double LogTable::suction_at(double value) const {
  if (value >= top_) return origin_;
  // The last piece whose left end is not below the value.
  std::size_t low = 0, high = pieces_;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (coefficients_[4 * middle] >= value ? low : high) = middle;
  }
  const double* c = &coefficients_[4 * low];
  double from = 0, to = left_end(low + 1) - left_end(low), d = to / 2;
  // Newton's method inside a bracket; the cubic falls over the piece.
  for (int iteration = 0; iteration < 100 && to - from > 1e-15 * (left_end(low) + to); ++iteration) {
    const double excess = c[0] + d * (c[1] + d * (c[2] + d * c[3])) - value;
    (excess > 0 ? from : to) = d;
    const double slope = c[1] + d * (2 * c[2] + 3 * d * c[3]), next = d - excess / slope;
    const double before = d;
    d = next >= from && next <= to ? next : 0.5 * (from + to);
    if (excess == 0 || std::abs(d - before) <= 1e-16 * (left_end(low) + d)) break;
  }
  return origin_ + left_end(low) + d;
}

}  // namespace wetfront::mpm
