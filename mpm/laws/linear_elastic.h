#pragma once

#include "mpm/laws/rotate.h"
#include "mpm/laws/stress_law.h"
#include "mpm/problem.h"

namespace wetfront::mpm {

/// Linear isotropic elasticity in increments: d sigma' = lambda tr(d eps) I + 2 mu d eps, with rotation.
class LinearElastic : public NoMemory {
 public:
  explicit LinearElastic(const Elastic& spec)
      : lambda_(spec.young * spec.poisson / ((1 + spec.poisson) * (1 - 2 * spec.poisson))),
        shear_(spec.young / (2 * (1 + spec.poisson))) {}

  template <int dim, class T>
  [[gnu::always_inline]] void advance(LawPoint<LinearElastic, dim, T>& point, const StepGradient<dim, T>& step) const {
    rotate<dim>(point.stress, step);
    add<dim>(point.stress, strain_of(step));
  }
  /// Stress of a strain, added.
  template <int dim, class T>
  [[gnu::always_inline]] void add(SymmetricTensor<dim, T>& stress, const SymmetricTensor<dim, T>& strain) const {
    const T volumetric = trace<dim>(strain) * lambda_;
    for (int k = 0; k < stress_components<dim>; ++k) stress[k] += strain[k] * (2 * shear_);
    for (int k = 0; k < 3; ++k) stress[k] += volumetric;
  }
  template <int dim, class T>
  double constrained_modulus(const LawPoint<LinearElastic, dim, T>&) const {
    return constrained_modulus();
  }
  double constrained_modulus() const { return lambda_ + 2 * shear_; }
  double lame() const { return lambda_; }
  double shear_modulus() const { return shear_; }
  double bulk_modulus() const { return lambda_ + 2 * shear_ / 3; }

 private:
  double lambda_, shear_;
};

static_assert(StressLaw<LinearElastic, 2> && StressLaw<LinearElastic, 3>);

}  // namespace wetfront::mpm
