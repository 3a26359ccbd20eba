#pragma once

#include "mpm/laws/tabulated.h"
#include "mpm/two_velocity/content.h"

#include <bit>
#include <cstdint>
#include <memory>
#include <vector>

namespace wetfront::mpm {

/// Where Newton's method for the pressure at a content begins: suction as a function of the effective saturation, as
/// cubics over pieces whose index is in the bits of 1 - Se (wet half) or of Se (dry half), 2^7 to every halving. From
/// 2^-26 on; the rest is left to the bracketed search.
class SuctionTable {
 public:
  explicit SuctionTable(const TabulatedCurve& curve);

  /// Suction [Pa] at Se, to 1e-8 of itself or better, and its slope; negative where the table does not reach.
  ValueAndSlope at(double effective) const {
    const double wet = 1 - effective;
    if (wet >= 0.5) return find(dry_, effective);
    const ValueAndSlope by_air = find(wet_, wet);
    return {by_air.value, -by_air.slope};
  }

 private:
  static constexpr int bits = 7, octaves = 25, shift = 52 - bits;
  static constexpr int last_exponent = -1, first_exponent = last_exponent - octaves;
  struct Piece {
    double c[4];
  };
  static double left_end(std::size_t index) { return std::bit_cast<double>(std::uint64_t(first() + index) << shift); }
  static std::uint64_t first() {
    return std::bit_cast<std::uint64_t>(std::bit_cast<double>(std::uint64_t(1023 + first_exponent) << 52)) >> shift;
  }
  static ValueAndSlope find(const std::vector<Piece>& pieces, double x) {
    const std::uint64_t left = std::bit_cast<std::uint64_t>(x) >> shift;
    const std::uint64_t index = left - first();
    if (index >= pieces.size()) return {-1, 0};
    const double d = x - std::bit_cast<double>(left << shift);
    const double* c = pieces[index].c;
    return {c[0] + d * (c[1] + d * (c[2] + d * c[3])), c[1] + d * (2 * c[2] + 3 * d * c[3])};
  }

  std::vector<Piece> wet_, dry_;
};

/// Water content of a soil and its inverse by tables: e(p) = S(p) (1 + p/K_l) (content.h) with S of a table, and the
/// pressure by Newton's method on the same e from a tabulated start: one or two iterations of 4 ns where powers take
/// 300. So e(pressure_of(c)) = c to round-off, and p differs from that of the closed law by what the table of S does
/// (LogTable: 1e-8 of S; content_table_test.cpp).
class TabulatedContent {
 public:
  TabulatedContent(const TabulatedCurve& curve, double bulk_modulus)
      : exact_(curve, bulk_modulus),
        start_(std::make_shared<const SuctionTable>(curve)),
        curve_(curve),
        per_modulus_(1 / bulk_modulus),
        s_min_(curve.s_min()),
        s_max_(curve.s_max()),
        per_range_(1 / (curve.s_max() - curve.s_min())) {}

  double value(double p) const { return curve_.saturation_at(-p).value * (1 + p * per_modulus_); }
  double slope(double p) const { return value_and_slope(p).slope; }
  double saturated() const { return s_max_; }
  /// S at a pressure that pressure_of gave for a content.
  double saturation(double content, double p) const { return content / (1 + p * per_modulus_); }

  ValueAndSlope value_and_slope(double p) const {
    const ValueAndSlope s = curve_.saturation_at(-p);
    const double c = 1 + p * per_modulus_;
    return {s.value * c, s.value * per_modulus_ - s.slope * c};
  }

  /// p with e(p) = content; NaN where no pressure gives it (content.h).
  double pressure_of(double content) const {
    if (content >= s_max_) return (content / s_max_ - 1) / per_modulus_;
    const ValueAndSlope suction = start_->at((content - s_min_) * per_range_);
    if (!(suction.value > 0)) return exact_.pressure_of(content);
    // S is more than the content by as much as the liquid is drawn apart: to first order in p/K_l.
    double p = -suction.value * (1 + suction.slope * per_range_ * content * per_modulus_);
    for (int iteration = 0; iteration < 8; ++iteration) {
      const ValueAndSlope here = value_and_slope(p);
      const double step = (content - here.value) / here.slope;
      p += step;
      if (!(p < 0)) break;
      if (std::abs(step) <= 1e-7 * std::abs(p)) return p;  // quadratic: what is left is below round-off
    }
    return exact_.pressure_of(content);
  }
  /// The slope at the pressure of a content below saturation, by the table's own: near enough for a step limit.
  double slope_near(double content) const {
    const ValueAndSlope suction = start_->at((content - s_min_) * per_range_);
    if (!(suction.value > 0 && suction.slope < 0)) return slope(exact_.pressure_of(content));
    const double c = 1 - suction.value * per_modulus_;
    return content * per_modulus_ - c / (suction.slope * per_range_);
  }

 private:
  WaterContent<TabulatedCurve> exact_;
  std::shared_ptr<const SuctionTable> start_;
  TabulatedCurve curve_;
  double per_modulus_, s_min_, s_max_, per_range_;
};

}  // namespace wetfront::mpm
