#pragma once

#include "reports/record.h"
#include "verification/study/point_result.h"

#include <vector>

/// What rain of several intensities does to a slope, told as Lee et al. 2021 tell it (their Fig. 7 and the critical
/// ratio of I/k_s that they read from it).
namespace wetfront::verification {

/// One intensity: rain over saturated conductivity [-], and what came of it.
struct RainOutcome {
  double ratio;
  double conductivity;  ///< k_s [m/s]
  const PointResult* result;
};

/// Where something changes on the way from weak to strong rain: "between .10 and .26".
struct Change {
  bool found = false;
  double below = 0, above = 0;  ///< ratios that lie next to each other [-]
  bool once = true;             ///< false: it changes back again
};
/// Between which ratios the order of wetting (base first / surface first) changes. Ascending; where it is not known a
/// ratio is left out.
Change change_of_wetting(const std::vector<RainOutcome>& rain);
/// The same of the type of failure (deep / shallow: what had moved when the slope failed).
Change change_of_failure(const std::vector<RainOutcome>& rain);

/// Four figures (speed of rise over k_s, time of rise, largest displacement, largest velocity, all over I/k_s, deep and
/// shallow failures told apart) and a table with the answer in words. Nothing where no run followed a slide. `rain` in
/// any order.
void tell_rain(reports::Record& record, std::vector<RainOutcome> rain);

/// Has it a place in one of the four figures?
bool told_with_rain(const Outcome& outcome);

}  // namespace wetfront::verification
