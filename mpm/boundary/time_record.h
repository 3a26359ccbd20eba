#pragma once

#include "mpm/problem.h"

#include <algorithm>

namespace wetfront::mpm {

/// Value of a record just before `time`, where a jump has not happened yet: what a step that ends there sees.
inline double value_until(const TimeRecord& record, double time) {
  const auto next = std::lower_bound(record.time.begin(), record.time.end(), time);
  if (next == record.time.end()) return record.value.back();
  const auto i = static_cast<std::size_t>(next - record.time.begin());
  if (i == 0) return record.value.front();
  const double part = (time - record.time[i - 1]) / (record.time[i] - record.time[i - 1]);
  return record.value[i - 1] + part * (record.value[i] - record.value[i - 1]);
}

}  // namespace wetfront::mpm
