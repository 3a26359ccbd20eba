#pragma once

#include "verification/study/point_result.h"
#include "verification/study/points.h"

#include <filesystem>
#include <string>
#include <vector>

/// Any study: points computed side by side, each in a process of its own, and none that is finished computed again.
namespace wetfront::verification {

struct StudyOptions {
  std::filesystem::path out;
  int jobs = 0;  ///< 0: as many as there are processors
  ReferenceStore store;
  std::vector<std::string> command;  ///< this program's own arguments; `--point K` is added for a worker
  std::vector<bool> wanted{};        ///< per point: false leaves it out, with a result that is empty; none: all
};

/// Computes the points that are not finished and returns all, in order. A worker that dies is a result with exit 3.
std::vector<PointResult> run_points(const std::filesystem::path& scene, const std::vector<StudyPoint>& points,
                                    const StudyOptions& options);

/// What is finished, in order; throws std::runtime_error naming the points that are not.
std::vector<PointResult> gather_points(const std::filesystem::path& scene, const std::vector<StudyPoint>& points,
                                       const std::filesystem::path& out);

}  // namespace wetfront::verification
