#include "verification/compare/reference_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

constexpr double observed_factor = 1.25, assumed_factor = 3, temporal_factor = 2;
constexpr double formal_order = 2;

bool is_missing(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double v) { return std::isnan(v); });
}

/// Sum of (b - a)(c - b): positive where the second change goes on in the direction of the first.
double agreement(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& c) {
  double sum = 0;
  for (std::size_t i = 0; i < b.size(); ++i) sum += (b[i] - a[i]) * (c[i] - b[i]);
  return sum;
}

/// Error of the middle mesh, of whose changes to the coarser and the finer one the last is `change`.
double richardson(double change, double order) {
  return change / (1 - std::exp2(-order));
}

void estimate_in_space(ReferenceError& error, const ReferenceValues& values, const Distance& distance) {
  const double second = distance(values.finer, values.reference);
  if (!values.coarser) {
    error.convergence = Convergence::two_meshes;
    error.spatial = assumed_factor * richardson(second, formal_order);
    return;
  }
  const double first = distance(*values.coarser, values.reference);
  const double larger = std::max(first, second);
  error.spatial = assumed_factor * larger;
  // Equal to rounding (an event that no mesh changes) is settled too.
  if (larger <= std::max(error.temporal, 1e-13)) {
    error.convergence = Convergence::settled;
  } else if (second >= first) {
    error.convergence = Convergence::divergent;
  } else if (agreement(*values.coarser, values.reference, values.finer) < 0) {
    error.convergence = Convergence::oscillatory;
  } else {
    error.convergence = Convergence::monotone;
    error.order = std::log2(first / second);
    const bool sound = error.order >= 1 && error.order <= 3;
    error.spatial = sound ? observed_factor * richardson(second, error.order)
                          : assumed_factor * richardson(second, std::clamp(error.order, 0.5, formal_order));
  }
}

}  // namespace

const char* word(Convergence convergence) {
  switch (convergence) {
    case Convergence::none:
      return "";
    case Convergence::monotone:
      return "monotone";
    case Convergence::oscillatory:
      return "oscillatory";
    case Convergence::divergent:
      return "divergent";
    case Convergence::settled:
      return "settled";
    case Convergence::two_meshes:
      return "two meshes only";
  }
  return "";
}

ReferenceError reference_error(const ReferenceValues& values, const Distance& distance) {
  ReferenceError error;
  int missing = is_missing(values.reference) + is_missing(values.finer) + is_missing(values.tighter);
  int solutions = 3;
  if (values.coarser) {
    missing += is_missing(*values.coarser);
    ++solutions;
  }
  if (missing > 0) {
    error.bound = missing == solutions ? std::numeric_limits<double>::quiet_NaN()  // nothing to be wrong about
                                       : std::numeric_limits<double>::infinity();
    error.spatial = error.temporal = error.bound;
    error.convergence = missing == solutions ? Convergence::settled : Convergence::divergent;
    return error;
  }
  error.temporal = temporal_factor * distance(values.tighter, values.reference);
  estimate_in_space(error, values, distance);
  error.bound = error.spatial + error.temporal;
  return error;
}

}  // namespace wetfront::verification
