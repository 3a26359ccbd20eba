#pragma once

#include "meshes/mesh.h"

#include <cmath>

namespace wetfront::verification {

/// Length of a vector.
inline double magnitude(const meshes::Point& x) {
  return std::hypot(x[0], x[1], x[2]);
}

}  // namespace wetfront::verification
