#pragma once

#include <array>
#include <cstddef>

/// Symmetric tensors are stored as xx, yy, zz, xy (plane strain) and xx, yy, zz, xy, yz, zx (three dimensions), shear
/// components as those of the tensor, not doubled. T is `double` or `Lanes`.
namespace wetfront::mpm {

template <int dim>
constexpr int stress_components = 2 * dim;

template <int dim, class T = double>
using SymmetricTensor = std::array<T, stress_components<dim>>;

/// Gradient of the displacement increment over a step, component [a][b] = d(u_a)/d(x_b) [-]. In plane strain a locking
/// remedy that spreads the volumetric strain over three axes also has a part along z.
template <int dim, class T = double>
struct StepGradient {
  std::array<std::array<T, dim>, dim> plane{};
  T zz{};  ///< plane strain only
};

/// The symmetric part. Lee 2021 Eq. 15 (integrated over the step).
template <int dim, class T>
[[gnu::always_inline]] inline SymmetricTensor<dim, T> strain_of(const StepGradient<dim, T>& step) {
  SymmetricTensor<dim, T> strain{};
  for (int a = 0; a < dim; ++a) strain[a] = step.plane[a][a];
  strain[3] = (step.plane[0][1] + step.plane[1][0]) * 0.5;
  if constexpr (dim == 2) strain[2] = step.zz;
  if constexpr (dim == 3) {
    strain[4] = (step.plane[1][2] + step.plane[2][1]) * 0.5;
    strain[5] = (step.plane[2][0] + step.plane[0][2]) * 0.5;
  }
  return strain;
}

template <int dim, class T>
T trace(const SymmetricTensor<dim, T>& tensor) {
  return tensor[0] + tensor[1] + tensor[2];
}

}  // namespace wetfront::mpm
