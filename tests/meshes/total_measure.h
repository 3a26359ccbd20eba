#pragma once

#include "meshes/mesh.h"

namespace wetfront::meshes {

/// Length, area or volume of all cells.
inline double total_measure(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) sum += mesh.cell_measure(c);
  return sum;
}

}  // namespace wetfront::meshes
