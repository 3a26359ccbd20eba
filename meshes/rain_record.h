#pragma once

#include <vector>

namespace wetfront::meshes {

/// Rain intensity over time, per horizontal area, piecewise constant: `intensity[i]` [m/s, >= 0]
/// holds from `start[i]` [s] until `start[i+1]`, the last one for ever; before `start[0]` it is dry.
/// Solvers must step exactly onto every `start`.
struct RainRecord {
  std::vector<double> start;
  std::vector<double> intensity;
};

/// Intensity just after `time` [m/s].
double intensity_after(const RainRecord& rain, double time);

/// Depth of rain fallen in [0, time] [m]: exact integral of the record.
double depth_until(const RainRecord& rain, double time);

}  // namespace wetfront::meshes
