#pragma once

#include "verification/compare/outcomes.h"
#include "verification/run/run_scene.h"
#include "verification/study/points.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What a finished point of a study leaves behind, beside its report.
namespace wetfront::verification {

struct PointResult {
  std::string name, hash;
  int exit = 0;         ///< of the run (architecture): 2: refused, 3: gave up
  std::string message;  ///< why it was refused or gave up
  double candidate_cpu = 0;
  std::size_t point_bytes = 0;  ///< that the plan allocates for material points
  std::vector<Outcome> candidate, reference;
  std::vector<reports::Finding> findings;
  double expected_cpu = 0;  ///< of a point left out for its cost: the CPU seconds that its plan expects; else 0

  bool left_out() const { return expected_cpu > 0; }
  /// Neither refused nor given up.
  bool ran() const { return exit != static_cast<int>(Exit::bad_input) && exit != static_cast<int>(Exit::gave_up); }
};

/// CPU seconds that the plan of a point expects; 0 for one that is refused: it costs nothing, and running it says why.
double expected_cpu(const std::filesystem::path& scene, const StudyPoint& point);

/// Computes a point into `folder`: report, result.json, run.log and, last and in one move, point.json. A scene that is
/// refused is a result too.
PointResult run_point(const std::filesystem::path& scene, const StudyPoint& point, const std::filesystem::path& folder,
                      const ReferenceStore& store);

/// The result kept in `folder`; absent where there is none, or that of another scene, other settings or another
/// version.
std::optional<PointResult> kept_point(const std::filesystem::path& folder, const std::string& hash);

}  // namespace wetfront::verification
