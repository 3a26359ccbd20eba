#pragma once

#include <vector>

namespace wetfront::meshes {

/// Rain intensity over time, per horizontal area, piecewise constant: `intensity[i]` [m/s, >= 0]
/// holds from `start[i]` [s] until `start[i+1]`, the last one for ever; before `start[0]` it is dry.
/// Solvers must step exactly onto every `start` at which the intensity changes.
struct RainRecord {
  std::vector<double> start;
  std::vector<double> intensity;
};

/// Intensity just after `time` [m/s].
double intensity_after(const RainRecord& rain, double time);

/// Depth of rain fallen in [0, time] [m]: exact integral of the record. Reads the whole record; RainDepth does not.
double depth_until(const RainRecord& rain, double time);

/// The starts at which the intensity differs from that before: dry hours of a record are one.
std::vector<double> changes(const RainRecord& rain);

/// depth_until for many times: sums once, then finds its row by bisection.
class RainDepth {
 public:
  explicit RainDepth(const RainRecord& rain);
  double until(double time) const;

 private:
  std::vector<double> start_, intensity_, depth_;  ///< rows from t = 0 on; depth at their starts [m]
};

}  // namespace wetfront::meshes
