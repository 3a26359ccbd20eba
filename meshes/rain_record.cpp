#include "meshes/rain_record.h"

#include <algorithm>
#include <cstddef>

namespace wetfront::meshes {

double intensity_after(const RainRecord& rain, double time) {
  const auto next = std::upper_bound(rain.start.begin(), rain.start.end(), time);
  if (next == rain.start.begin()) return 0;
  return rain.intensity[next - rain.start.begin() - 1];
}

double depth_until(const RainRecord& rain, double time) {
  double depth = 0;
  for (std::size_t i = 0; i < rain.start.size(); ++i) {
    const double from = std::max(rain.start[i], 0.0);
    const double until = i + 1 < rain.start.size() ? std::min(rain.start[i + 1], time) : time;
    if (until > from) depth += rain.intensity[i] * (until - from);
    if (until == time) break;
  }
  return depth;
}

}  // namespace wetfront::meshes
