#pragma once

#include <bit>
#include <cstdint>
#include <functional>
#include <vector>

namespace wetfront::mpm {

struct ValueAndSlope {
  double value = 1;  ///< - (k_rel, Se or a content)
  double slope = 0;  ///< its derivative [1/Pa]
};

/// A law of suction s, not rising, as it is sampled: constant `top` for s <= origin, `at(s)` beyond.
struct SampledLaw {
  double top = 1;     ///< -
  double origin = 0;  ///< Pa
  std::function<ValueAndSlope(double)> at;
};

/// A law of suction as a piecewise cubic: 2^7 pieces to every doubling of x = s - origin, so that the bits of x are the
/// index and no logarithm is needed. Hermite's: values and slopes of the law at the ends of a piece, hence one
/// continuous function with a continuous slope, which is what `at` returns; `integral` is its exact integral.
///
/// Bound. On a piece of width d = x/128 the error is at most d^4/384 max|f''''|. For f ~ x^-q, which is what the
/// branches of all laws are, that is q(q+1)(q+2)(q+3) f / (384 128^4): 8e-9 f for q = 4, 5e-6 f for q = 25. An
/// exponential exp(-s/c) has q = s/c: its error is at most max(q^4 exp(-q)) / (384 128^4) = 5e-11 of its top. The first
/// piece, [0, 2^first_exponent], blends from the top with a continuous slope where the law's own is unbounded there:
/// the error is at most top - f(2^first_exponent). laws_table_test.cpp holds all laws to this.
class LogTable {
 public:
  LogTable() = default;
  /// Samples a law from x = 2^first_exponent to 2^40 Pa; constant beyond.
  LogTable(const SampledLaw& law, int first_exponent);

  ValueAndSlope at(double s) const {
    const double x = s - origin_;
    if (!(x > 0)) return {top_, 0};
    const Piece piece = find(x);
    const double* c = &coefficients_[4 * piece.index];
    const double d = piece.offset;
    return {c[0] + d * (c[1] + d * (c[2] + d * c[3])), c[1] + d * (2 * c[2] + 3 * d * c[3])};
  }
  double value(double s) const { return at(s).value; }
  /// Integral from s to the dry end [Pa]: small where the law is small, so that differences keep their digits there.
  double integral(double s) const {
    const double x = s - origin_;
    if (!(x > 0)) return integrals_.front() - top_ * x;
    const Piece piece = find(x);
    const double* c = &coefficients_[4 * piece.index];
    const double d = piece.offset;
    return integrals_[piece.index] - d * (c[0] + d * (c[1] / 2 + d * (c[2] / 3 + d * c[3] / 4)));
  }
  /// The suction at which the table has a value: `origin` for the top and above, the dry end for less than it holds.
  double suction_at(double value) const;
  double origin() const { return origin_; }

 private:
  static constexpr int bits = 7, last_exponent = 40;
  static constexpr int shift = 52 - bits;

  struct Piece {
    std::size_t index;
    double offset;  ///< from its left end
  };
  Piece find(double x) const {
    const auto pattern = std::bit_cast<std::uint64_t>(x);
    if (pattern < first_pattern_) return {0, x};
    const std::uint64_t left = pattern >> shift;
    const std::size_t index = static_cast<std::size_t>(left - (first_pattern_ >> shift)) + 1;
    if (index >= pieces_) return {pieces_, 0};
    return {index, x - std::bit_cast<double>(left << shift)};
  }
  double left_end(std::size_t index) const;
  void fit(std::size_t index, double width, const ValueAndSlope& left, const ValueAndSlope& right);

  double top_ = 1, origin_ = 0;
  std::uint64_t first_pattern_ = 0;
  std::size_t pieces_ = 0;
  std::vector<double> coefficients_;  ///< four per piece, and one constant piece at the end
  std::vector<double> integrals_;     ///< from the left end of each piece to the dry end
};

}  // namespace wetfront::mpm
