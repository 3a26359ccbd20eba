#pragma once

#include "fem_reference/soil/soil_curves.h"

#include <functional>
#include <vector>

namespace wetfront::fem_reference {

/// Water taken up by the pores of an elastic skeleton under constant total stress, as an addition to W [-]:
/// the integral of f = S (chi + p dchi/dp) / E_oed over the pore pressure p from 0, per m of head. Tabulated once as
/// cubics in log(1 + suction / 1 mm), whose own derivative is the slope, so that W and its slope agree exactly.
/// Drier than `limit()` f counts as 0: there f (negative where the soil is dry) would make W fall with the head.
class SkeletonStorage {
 public:
  /// `rate(psi)`: f times the unit weight [1/m] for psi <= full; constant above `full` [m]. `capacity(psi)`: slope of
  /// the rest of W [1/m].
  SkeletonStorage(double full, const std::function<double(double)>& rate,
                  const std::function<double(double)>& capacity);

  ValueAndSlope operator()(double head) const;
  /// Below this head W would fall with rising head [m]; driest_head where it never does.
  double limit() const { return limit_; }
  static constexpr double driest_head = -1e4;  ///< m; the table ends here (1e8 Pa, an air-dry soil)

 private:
  double full_, rate_full_, limit_;
  std::vector<double> value_, slope_;  ///< at the nodes of the table; slope with respect to its coordinate
};

}  // namespace wetfront::fem_reference
