#pragma once

#include "mpm/grid/stencil.h"
#include "mpm/problem.h"

#include <concepts>

/// Effective stress of the skeleton, tension-positive. Symmetric tensors are stored as xx, yy, zz, xy (plane strain)
/// and xx, yy, zz, xy, yz, zx (three dimensions).
namespace wetfront::mpm {

template <int dim>
constexpr int stress_components = 2 * dim;

template <int dim>
using SymmetricTensor = std::array<double, stress_components<dim>>;

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// A law without memory of its own.
struct Empty {};

/// Adds the stress increment of a strain increment; `State` is what a point has to remember besides its stress.
template <class Law, int dim>
concept StressLaw = requires(const Law& law, SymmetricTensor<dim>& stress, const SymmetricTensor<dim>& strain,
                             typename Law::State& state) {
  law(stress, strain, state);
  { law.constrained_modulus() } -> std::convertible_to<double>;  ///< E_oed [Pa], sets the wave speed
};

/// Linear isotropic elasticity: d sigma' = lambda tr(d eps) I + 2 mu d eps.
class LinearElastic {
 public:
  using State = Empty;
  explicit LinearElastic(const Elastic& spec)
      : lambda_(spec.young * spec.poisson / ((1 + spec.poisson) * (1 - 2 * spec.poisson))),
        shear_(spec.young / (2 * (1 + spec.poisson))) {}

  template <std::size_t n>
  void operator()(std::array<double, n>& stress, const std::array<double, n>& strain, Empty&) const {
    const double volumetric = strain[0] + strain[1] + strain[2];
    for (std::size_t k = 0; k < n; ++k) stress[k] += 2 * shear_ * strain[k] + (k < 3 ? lambda_ * volumetric : 0.0);
  }
  double constrained_modulus() const { return lambda_ + 2 * shear_; }

 private:
  double lambda_, shear_;
};

static_assert(StressLaw<LinearElastic, 2> && StressLaw<LinearElastic, 3>);

/// Symmetric part of grad v dt, with (grad v)_ij = d_j v_i. Lee 2021 Eq. 15.
template <int dim>
SymmetricTensor<dim> strain_increment(const std::array<Vector<dim>, dim>& increment) {
  SymmetricTensor<dim> strain{};
  for (int a = 0; a < dim; ++a) strain[a] = increment[a][a];
  strain[3] = 0.5 * (increment[0][1] + increment[1][0]);
  if constexpr (dim == 3) {
    strain[4] = 0.5 * (increment[1][2] + increment[2][1]);
    strain[5] = 0.5 * (increment[2][0] + increment[0][2]);
  }
  return strain;
}

/// Jaumann's part of the stress increment, W sigma - sigma W with W = (grad v - grad v^T) dt / 2. Lee 2021 Eq. 16 has
/// the opposite sign for this W, and Eq. 17 lacks the factor 1/2 (benchmarks.md section 8, items 11 to 13).
template <int dim>
SymmetricTensor<dim> rotation_increment(const SymmetricTensor<dim>& stress,
                                        const std::array<Vector<dim>, dim>& increment) {
  Matrix3 s{}, w{};
  for (int a = 0; a < 3; ++a) s[a][a] = stress[a];
  s[0][1] = s[1][0] = stress[3];
  if constexpr (dim == 3) {
    s[1][2] = s[2][1] = stress[4];
    s[0][2] = s[2][0] = stress[5];
  }
  for (int a = 0; a < dim; ++a)
    for (int b = 0; b < dim; ++b) w[a][b] = 0.5 * (increment[a][b] - increment[b][a]);
  const auto entry = [&](int a, int b) {
    double sum = 0;
    for (int c = 0; c < dim; ++c) sum += w[a][c] * s[c][b] - s[a][c] * w[c][b];
    return sum;
  };
  SymmetricTensor<dim> out{};
  for (int a = 0; a < dim; ++a) out[a] = entry(a, a);
  out[3] = entry(0, 1);
  if constexpr (dim == 3) {
    out[4] = entry(1, 2);
    out[5] = entry(2, 0);
  }
  return out;
}

}  // namespace wetfront::mpm
