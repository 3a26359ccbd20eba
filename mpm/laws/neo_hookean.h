#pragma once

#include "mpm/laws/deformation_gradient.h"
#include "mpm/laws/linear_elastic.h"

namespace wetfront::mpm {

/// P = lambda ln J F^-T + mu (F - F^-T), that is sigma = (lambda ln J I + mu (b - I))/J. The stress follows from the
/// deformation alone, so an initial stress is not kept. J <= 0 gives a stress that is not finite.
class NeoHookeanLaw : public DeformationMemory {
 public:
  explicit NeoHookeanLaw(const Elastic& elastic) : elastic_(elastic) {}

  template <int dim, class T>
  void advance(LawPoint<NeoHookeanLaw, dim, T>& point, const StepGradient<dim, T>& step) const {
    using std::log;
    stretch<dim>(point.memory, step);
    const T j = volume_ratio<dim>(point.memory), inverse = T(1.0) / j;
    const SymmetricTensor<dim, T> b = left_cauchy_green<dim>(point.memory);
    const T shear = inverse * elastic_.shear_modulus(), isotropic = log(j) * inverse * elastic_.lame() - shear;
    for (int k = 0; k < stress_components<dim>; ++k) point.stress[k] = b[k] * shear;
    for (int k = 0; k < 3; ++k) point.stress[k] += isotropic;
  }
  /// The largest of (lambda + mu - lambda ln J + mu n.b.n)/J over directions n, bounded with the trace of b.
  template <int dim, class T>
  double constrained_modulus(const LawPoint<NeoHookeanLaw, dim, T>& point) const {
    const double j = volume_ratio<dim>(point.memory);
    const SymmetricTensor<dim, double> b = left_cauchy_green<dim>(point.memory);
    const double mean = (b[0] + b[1]) / 2, radius = std::hypot((b[0] - b[1]) / 2, b[3]);
    const double largest = dim == 2 ? std::max(mean + radius, b[2]) : trace<dim>(b);
    return (elastic_.lame() * (1 - std::log(j)) + elastic_.shear_modulus() * (1 + largest)) / j;
  }

 private:
  LinearElastic elastic_;
};

static_assert(StressLaw<NeoHookeanLaw, 2> && StressLaw<NeoHookeanLaw, 3>);

}  // namespace wetfront::mpm
