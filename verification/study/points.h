#pragma once

#include "verification/scene/set_value.h"

#include <filesystem>
#include <string>
#include <vector>

/// The points of a study: one scene, each time with some values set anew.
namespace wetfront::verification {

/// A value of the scene and what it is to be, one after the other.
struct Variation {
  std::string path;
  std::vector<std::string> values;
};
/// "rain.intensity=1e-5,2e-5"; commas within brackets belong to a value, an empty one leaves the key out. Throws
/// SceneError.
Variation read_variation(const std::string& text);

struct StudyPoint {
  std::string name;  ///< "rain.intensity=1e-5, mpm.points_per_cell=9"
  std::vector<Setting> settings;
};
/// Every combination, the last variation turning fastest. Throws SceneError for a path given twice.
std::vector<StudyPoint> product(const std::vector<Variation>& variations);

/// Names what a point computes: the scene's text with its settings, the files that it names, the version of the
/// program.
std::string point_hash(const std::filesystem::path& scene, const StudyPoint& point);

/// "003_rain.intensity-1e-5": where point number `index` leaves its results.
std::filesystem::path point_folder(const std::filesystem::path& out, std::size_t index, const StudyPoint& point);

}  // namespace wetfront::verification
