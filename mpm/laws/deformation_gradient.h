#pragma once

#include "mpm/laws/stress_law.h"

#include <algorithm>

namespace wetfront::mpm {

/// The deformation gradient in a law's memory: row by row, and the stretch along z behind them in plane strain.
template <int dim>
constexpr int gradient_size = dim == 2 ? 5 : 9;

/// What laws of the deformation gradient have in common; they derive from this.
struct DeformationMemory {
  template <int dim>
  static constexpr int memory_size = gradient_size<dim>;
  static constexpr bool needs_suction = false;
  static constexpr bool modulus_varies = true;  ///< constrained_modulus depends on the point: asked point by point
  static std::vector<ColumnSpec> memory_specs(int dim) {
    return {{"deformation gradient", "F", "-", dim == 2 ? gradient_size<2> : gradient_size<3>}};
  }

  template <class Law, int dim, class T>
  void begin(LawPoint<Law, dim, T>& point) const {
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b) point.memory[a * dim + b] = T(a == b ? 1.0 : 0.0);
    if constexpr (dim == 2) point.memory[4] = T(1.0);
  }
};

/// F <- (I + grad du) F: exact for the motion of a step, whose gradient is taken at the places at its beginning.
template <int dim, class T>
void stretch(std::array<T, gradient_size<dim>>& f, const StepGradient<dim, T>& step) {
  const std::array<T, gradient_size<dim>> old = f;
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b)
      for (int c = 0; c < dim; ++c) f[a * dim + b] += step.plane[a][c] * old[c * dim + b];
  if constexpr (dim == 2) f[4] += step.zz * old[4];
}

/// J = det F.
template <int dim, class T>
T volume_ratio(const std::array<T, gradient_size<dim>>& f) {
  if constexpr (dim == 2)
    return (f[0] * f[3] - f[1] * f[2]) * f[4];
  else
    return f[0] * (f[4] * f[8] - f[5] * f[7]) - f[1] * (f[3] * f[8] - f[5] * f[6]) + f[2] * (f[3] * f[7] - f[4] * f[6]);
}

/// b = F F^T.
template <int dim, class T>
SymmetricTensor<dim, T> left_cauchy_green(const std::array<T, gradient_size<dim>>& f) {
  const auto entry = [&f](int a, int b) {
    T sum{};
    for (int c = 0; c < dim; ++c) sum += f[a * dim + c] * f[b * dim + c];
    return sum;
  };
  if constexpr (dim == 2)
    return {entry(0, 0), entry(1, 1), f[4] * f[4], entry(0, 1)};
  else
    return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(2, 0)};
}

}  // namespace wetfront::mpm
