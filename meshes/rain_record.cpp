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
  return RainDepth(rain).until(time);
}

std::vector<double> changes(const RainRecord& rain) {
  std::vector<double> times;
  double before = 0;
  for (std::size_t i = 0; i < rain.start.size(); ++i) {
    if (rain.intensity[i] != before) times.push_back(rain.start[i]);
    before = rain.intensity[i];
  }
  return times;
}

RainDepth::RainDepth(const RainRecord& rain) {
  double depth = 0;
  for (std::size_t i = 0; i < rain.start.size(); ++i) {
    if (i + 1 < rain.start.size() && rain.start[i + 1] <= 0) continue;
    start_.push_back(std::max(rain.start[i], 0.0));
    intensity_.push_back(rain.intensity[i]);
    depth_.push_back(depth);
    if (i + 1 < rain.start.size()) depth += rain.intensity[i] * (rain.start[i + 1] - start_.back());
  }
}

double RainDepth::until(double time) const {
  const auto next = std::upper_bound(start_.begin(), start_.end(), time);
  if (next == start_.begin()) return 0;
  const std::size_t i = next - start_.begin() - 1;
  return depth_[i] + intensity_[i] * (time - start_[i]);
}

}  // namespace wetfront::meshes
