#pragma once

#include "meshes/mesh.h"
#include "verification/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace wetfront::verification {

/// The scene's times in seconds, and the rain it asks for.
struct Timeline {
  std::optional<double> filling_time;    ///< storage deficit / rain [s]; absent where the scene has none
  std::vector<double> stage_end;         ///< s
  std::vector<double> comparison_times;  ///< s
  std::vector<double> tolerance_times;   ///< s, one per tolerance; NaN: all comparison times
  double end() const { return stage_end.back(); }
};

/// Resolves "25 % of filling" and the like. Throws std::runtime_error where there is no filling time.
Timeline timeline(const Scene& scene);

/// Horizontal area under rain [m2/m; in space m2].
double rain_area(const Scene& scene, const meshes::Mesh& mesh);

/// Horizontal area that a water ledger is told per [m2/m]: that under rain or, where none falls, the width of the
/// ground.
double ledger_area(const Scene& scene, const meshes::Mesh& mesh);

/// Rain volume that the scene asks for in [0, time] [m3/m]: exact integral of the record times the area.
double rain_asked(const Scene& scene, const meshes::Mesh& mesh, double time);

/// "25 % of filling (1772 s)" or "600 s".
std::string describe(const SceneTime& time, double seconds);

}  // namespace wetfront::verification
