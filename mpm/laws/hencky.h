#pragma once

#include "mpm/laws/deformation_gradient.h"
#include "mpm/laws/linear_elastic.h"
#include "mpm/laws/principal_stress.h"

namespace wetfront::mpm {

/// Kirchhoff stress linear in the logarithmic strain: tau = lambda tr(e) I + 2 mu e, e = ln(b)/2, sigma = tau/J. The
/// stress follows from the deformation alone, so an initial stress is not kept.
class HenckyLaw : public DeformationMemory {
 public:
  explicit HenckyLaw(const Elastic& elastic) : elastic_(elastic) {}

  template <int dim, class T>
  void advance(LawPoint<HenckyLaw, dim, T>& point, const StepGradient<dim, T>& step) const {
    using std::log;
    stretch<dim>(point.memory, step);
    Principal<dim, T> b(left_cauchy_green<dim>(point.memory));
    const T inverse = T(1.0) / volume_ratio<dim>(point.memory);
    std::array<T, 3> strain;
    for (int k = 0; k < 3; ++k) strain[k] = log(b.values[k]) * 0.5;
    const T volumetric = (strain[0] + strain[1] + strain[2]) * elastic_.lame();
    for (int k = 0; k < 3; ++k) b.values[k] = (strain[k] * (2 * elastic_.shear_modulus()) + volumetric) * inverse;
    point.stress = b.tensor();
  }
  /// (E_oed - tau_3)/J, which is the stiffness along the axis of the most compressed principal stress, exactly so in
  /// uniaxial strain.
  template <int dim, class T>
  double constrained_modulus(const LawPoint<HenckyLaw, dim, T>& point) const {
    const Principal<dim, double> stress(point.stress);
    return elastic_.constrained_modulus() / volume_ratio<dim>(point.memory) - std::min(stress.values[2], 0.0);
  }

 private:
  LinearElastic elastic_;
};

static_assert(StressLaw<HenckyLaw, 2> && StressLaw<HenckyLaw, 3>);

}  // namespace wetfront::mpm
