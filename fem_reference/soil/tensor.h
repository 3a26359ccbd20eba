#pragma once

#include "fem_reference/richards_problem.h"

namespace wetfront::fem_reference {

/// T v of a symmetric tensor {xx, yy, zz, xy, yz, zx}.
inline meshes::Point times(const std::array<double, 6>& t, const meshes::Point& v) {
  return {t[0] * v[0] + t[3] * v[1] + t[5] * v[2], t[3] * v[0] + t[1] * v[1] + t[4] * v[2],
          t[5] * v[0] + t[4] * v[1] + t[2] * v[2]};
}

constexpr std::array<double, 6> isotropic{1, 1, 1, 0, 0, 0};

}  // namespace wetfront::fem_reference
