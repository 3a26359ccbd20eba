#include "fem_reference/soil/tensor.h"

#include <cmath>

namespace wetfront::fem_reference {

std::array<double, 6> principal_tensor(int dim, const std::array<double, 3>& values, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double along = values[0], across = values[meshes::up_axis(dim)];
  const double xx = c * c * along + s * s * across, up = s * s * along + c * c * across,
               mixed = c * s * (along - across);
  if (dim == 1) return {values[0], 1, 1, 0, 0, 0};
  if (dim == 2) return {xx, up, values[2], mixed, 0, 0};
  return {xx, values[1], up, 0, 0, mixed};
}

}  // namespace wetfront::fem_reference
