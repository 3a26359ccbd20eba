#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "verification/exact/validity.h"

namespace wetfront::verification::exact {

/// Sum of a series whose terms carry exp(-decay) with decay growing from term to term. It knows its own error: terms
/// are cut at exp(-46) = 1e-20, and the rounding error is bounded by epsilon times the sum of the terms' magnitudes.
class DecayingSeries {
 public:
  static constexpr double negligible = 46;

  void add(double term) { sum_ += term, magnitude_ += std::abs(term); }
  double sum() const { return sum_; }

  /// For background - factor * sum: throws std::domain_error unless it is known to `relative_accuracy`.
  /// `complete` says whether the cut was reached; if not, t was too small for the number of terms.
  double subtract_from(double background, double factor, bool complete, const std::string& name) const {
    require_point(complete, name + ": t is too small for the number of terms kept; raise `terms`");
    const double value = background - factor * sum_;
    const double rounding =
        std::numeric_limits<double>::epsilon() * (std::abs(background) + std::abs(factor) * magnitude_);
    require_point(rounding <= relative_accuracy * std::abs(value),
                  name + ": cancellation leaves fewer than 8 digits here (the layer is many 1/alpha thick, t small)");
    return value;
  }

  static constexpr double relative_accuracy = 1e-8;

 private:
  double sum_ = 0, magnitude_ = 0;
};

}  // namespace wetfront::verification::exact
