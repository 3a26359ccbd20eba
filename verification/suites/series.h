#pragma once

#include "reports/record.h"

#include <string>

namespace wetfront::verification {

/// A series without values yet. `colour`: series that belong together share one; -1: the next free.
inline reports::Series line(const std::string& label, int colour = -1) {
  return {label, reports::Series::Style::line, {}, {}, colour};
}
inline reports::Series dashed(const std::string& label, int colour = -1) {
  return {label, reports::Series::Style::dashed, {}, {}, colour};
}
inline reports::Series points(const std::string& label, int colour = -1) {
  return {label, reports::Series::Style::points, {}, {}, colour};
}

inline void put(reports::Series& series, double x, double y) {
  series.x.push_back(x);
  series.y.push_back(y);
}

}  // namespace wetfront::verification
