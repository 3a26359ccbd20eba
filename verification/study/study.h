#pragma once

#include "verification/study/point_result.h"
#include "verification/study/points.h"

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// Any study: points computed side by side, each in a process of its own, and none that is finished computed again.
namespace wetfront::verification {

struct StudyOptions {
  std::filesystem::path out;
  int jobs = 0;  ///< 0: as many as there are processors
  ReferenceStore store;
  std::vector<std::string> command;  ///< this program's own arguments; `--point K` is added for a worker
  /// CPU seconds that a point may be expected to cost. One that is not finished and costs more is left out.
  double budget = std::numeric_limits<double>::infinity();
  std::size_t always = 0;  ///< so many points at the front are wanted at any cost
};

/// What each point has left in `out`, in order; absent where it is not finished.
std::vector<std::optional<PointResult>> kept_points(const std::filesystem::path& scene,
                                                    const std::vector<StudyPoint>& points,
                                                    const std::filesystem::path& out);

/// Computes the points that are not finished and returns all, in order. A worker that dies is a result with exit 3.
std::vector<PointResult> run_points(const std::filesystem::path& scene, const std::vector<StudyPoint>& points,
                                    const StudyOptions& options);

/// What is finished or left out, in order; throws std::runtime_error naming the points that are missing.
std::vector<PointResult> gather_points(const std::filesystem::path& scene, const std::vector<StudyPoint>& points,
                                       const StudyOptions& options);

}  // namespace wetfront::verification
