#include "verification/run/finer_cells.h"

#include <algorithm>
#include <cmath>

namespace wetfront::verification {

Scene with_finer_cells(const Scene& scene, double factor) {
  Scene out = scene;
  Shape& shape = out.geometry.shape;
  const auto refine = [factor](int& cells) { cells = std::max(1, static_cast<int>(std::lround(factor * cells))); };
  if (auto* column = std::get_if<Column>(&shape)) refine(column->cells);
  if (auto* slope = std::get_if<Slope>(&shape)) refine(slope->cells_along), refine(slope->cells_over);
  if (auto* profile = std::get_if<GroundProfile>(&shape)) refine(profile->cells_along), refine(profile->cells_over);
  if (auto* box = std::get_if<Box>(&shape)) std::ranges::for_each(box->cells, refine);
  return out;
}

}  // namespace wetfront::verification
