#include "verification/run/finer_cells.h"

namespace wetfront::verification {

Scene with_finer_cells(const Scene& scene, int factor) {
  Scene out = scene;
  Shape& shape = out.geometry.shape;
  if (auto* column = std::get_if<Column>(&shape)) column->cells *= factor;
  if (auto* slope = std::get_if<Slope>(&shape)) slope->cells_along *= factor, slope->cells_over *= factor;
  if (auto* profile = std::get_if<GroundProfile>(&shape)) profile->cells_along *= factor, profile->cells_over *= factor;
  if (auto* box = std::get_if<Box>(&shape))
    for (int& cells : box->cells) cells *= factor;
  return out;
}

}  // namespace wetfront::verification
