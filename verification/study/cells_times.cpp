#include "verification/study/cells_times.h"

#include "verification/scene/read.h"

#include <fmt/format.h>

#include <cmath>

namespace wetfront::verification {
namespace {

struct Count {
  std::string path;
  int cells;
};

std::vector<Count> cell_counts(const Geometry& geometry) {
  const Shape& shape = geometry.shape;
  if (const auto* column = std::get_if<Column>(&shape)) return {{"geometry.column.cells", column->cells}};
  if (const auto* slope = std::get_if<Slope>(&shape))
    return {{"geometry.slope.cells_along", slope->cells_along}, {"geometry.slope.cells_over", slope->cells_over}};
  if (const auto* profile = std::get_if<GroundProfile>(&shape))
    return {{"geometry.profile.cells_along", profile->cells_along},
            {"geometry.profile.cells_over", profile->cells_over}};
  if (const auto* box = std::get_if<Box>(&shape)) {
    std::vector<Count> counts;
    for (std::size_t i = 0; i < box->cells.size(); ++i)
      counts.push_back({"geometry.box.cells[" + std::to_string(i) + "]", box->cells[i]});
    return counts;
  }
  throw SceneError({geometry.origin.text() +
                    ": a mesh of your own cannot be studied with other cells (they cannot be made from here). Describe "
                    "the ground by a shape."});
}

}  // namespace

std::vector<Setting> cells_times(const Scene& scene, double factor) {
  std::vector<Setting> settings;
  for (const Count& count : cell_counts(scene.geometry)) {
    const double wanted = factor * count.cells;
    if (wanted != std::floor(wanted) || wanted < 2) return {};
    settings.push_back({count.path, fmt::format("{:.0f}", wanted)});
  }
  return settings;
}

}  // namespace wetfront::verification
