#pragma once

#include "mpm/laws/tensor.h"

namespace wetfront::mpm {

/// Turns a stress with the step, Q sigma Q^T with Q = (I - W/2)^-1 (I + W/2), W = (grad - grad^T)/2 of the step: the
/// midpoint form of Jaumann's rate (Hughes & Winget 1980), which keeps the invariants of the stress exactly. To first
/// order it is W sigma - sigma W; Lee 2021 Eq. 16 has the opposite sign for this W, and Eq. 17 lacks the factor 1/2
/// (benchmarks.md section 8, items 11 to 13).
template <int dim, class T>
[[gnu::always_inline]] inline void rotate(SymmetricTensor<dim, T>& stress, const StepGradient<dim, T>& step) {
  if constexpr (dim == 2) {
    const T half = (step.plane[1][0] - step.plane[0][1]) * 0.25;  // tan of half the angle
    const T scale = T(1.0) / (half * half + 1.0);
    const T c = (T(1.0) - half * half) * scale, s = half * 2.0 * scale;
    const T mean = (stress[0] + stress[1]) * 0.5, half_difference = (stress[0] - stress[1]) * 0.5, shear = stress[3];
    const T c2 = c * c - s * s, s2 = c * s * 2.0;
    const T turned = half_difference * c2 - shear * s2;
    stress[0] = mean + turned;
    stress[1] = mean - turned;
    stress[3] = half_difference * s2 + shear * c2;
  } else {
    // Q of the axial vector w of W/2 (Cayley): Q = I + 2/(1 + w.w) (w^ + w^ w^).
    const T wx = (step.plane[2][1] - step.plane[1][2]) * 0.25, wy = (step.plane[0][2] - step.plane[2][0]) * 0.25,
            wz = (step.plane[1][0] - step.plane[0][1]) * 0.25;
    const T k = T(2.0) / (wx * wx + wy * wy + wz * wz + 1.0);
    const std::array<std::array<T, 3>, 3> q{
        {{T(1.0) - k * (wy * wy + wz * wz), k * (wx * wy - wz), k * (wx * wz + wy)},
         {k * (wx * wy + wz), T(1.0) - k * (wx * wx + wz * wz), k * (wy * wz - wx)},
         {k * (wx * wz - wy), k * (wy * wz + wx), T(1.0) - k * (wx * wx + wy * wy)}}};
    const std::array<std::array<T, 3>, 3> s{
        {{stress[0], stress[3], stress[5]}, {stress[3], stress[1], stress[4]}, {stress[5], stress[4], stress[2]}}};
    const auto entry = [&](int a, int b) {
      T sum{};
      for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d) sum += q[a][c] * s[c][d] * q[b][d];
      return sum;
    };
    stress = {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(2, 0)};
  }
}

}  // namespace wetfront::mpm
