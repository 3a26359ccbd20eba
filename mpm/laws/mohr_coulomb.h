#pragma once

#include "mpm/laws/linear_elastic.h"
#include "mpm/laws/mohr_coulomb_return.h"
#include "mpm/laws/principal_stress.h"

namespace wetfront::mpm {

/// Strength of the parameters of a scene. `has_cut_off`: a cut-off below the apex.
inline MohrCoulombStrength<double> strength_of(const MohrCoulomb& spec) {
  const double apex = spec.friction > 0 ? spec.cohesion / std::tan(spec.friction) : std::numeric_limits<double>::max();
  return {std::sin(spec.friction), 2 * spec.cohesion * std::cos(spec.friction), std::sin(spec.dilatancy),
          std::min(spec.tension_cut_off.value_or(apex), apex)};
}
inline bool has_cut_off(const MohrCoulomb& spec) {
  return spec.tension_cut_off &&
         (!(spec.friction > 0) || *spec.tension_cut_off < spec.cohesion / std::tan(spec.friction));
}

/// Whether a stress may lie outside of the surface: never wrong, and in three dimensions cheap where it says no
/// (2 sqrt(J2) sqrt(1 + sin^2 phi/3) + 2 p sin phi bounds f + 2 c cos phi over all Lode angles).
template <class T, class S>
auto may_yield(const SymmetricTensor<3, T>& stress, const MohrCoulombStrength<S>& strength, bool cut_off) {
  const T mean = trace<3>(stress) * (1.0 / 3.0);
  const T x = stress[0] - mean, y = stress[1] - mean, z = stress[2] - mean;
  const T deviator =
      sqrt((x * x + y * y + z * z) * 0.5 + stress[3] * stress[3] + stress[4] * stress[4] + stress[5] * stress[5]);
  const S& sf = strength.sin_friction;
  auto may = deviator * (sqrt(sf * sf * (1.0 / 3.0) + 1.0) * 2.0) + mean * (sf * 2.0) > strength.cohesive;
  if (cut_off) may = may || mean + deviator * (2.0 / 1.7320508075688772) > strength.cut_off;
  return may;
}

/// Brings a trial stress back to the surface if it lies outside. Says (per lane) whether it did.
template <int dim, class T, class S>
[[gnu::always_inline]] inline auto return_to_surface(SymmetricTensor<dim, T>& stress,
                                                     const MohrCoulombReturn<S>& surface,
                                                     const MohrCoulombStrength<S>& strength, bool cut_off) {
  if constexpr (dim == 3)
    if (const auto may = may_yield(stress, strength, cut_off); !any(may)) return may;
  Principal<dim, T> principal(stress);
  auto outside = surface.yield(principal.values[0], principal.values[2]) > 0.0;
  if (cut_off) outside = outside || principal.values[0] > strength.cut_off;
  if (!any(outside)) return outside;
  principal.values = cut_off ? surface.with_cut_off(principal.values) : surface.without_cut_off(principal.values);
  const SymmetricTensor<dim, T> returned = principal.tensor();
  for (int k = 0; k < stress_components<dim>; ++k) stress[k] = select(outside, returned[k], stress[k]);
  return outside;
}

/// Linear elastic, perfectly plastic with Mohr-Coulomb's strength, non-associated, optionally cut off in tension.
class MohrCoulombLaw : public NoMemory {
 public:
  MohrCoulombLaw(const Elastic& elastic, const MohrCoulomb& spec)
      : elastic_(elastic),
        strength_(strength_of(spec)),
        surface_(strength_, elastic_.lame(), elastic_.shear_modulus()),
        cut_off_(has_cut_off(spec)) {}

  template <int dim, class T>
  [[gnu::always_inline]] void advance(LawPoint<MohrCoulombLaw, dim, T>& point, const StepGradient<dim, T>& step) const {
    rotate<dim>(point.stress, step);
    elastic_.add<dim>(point.stress, strain_of(step));
    return_to_surface<dim>(point.stress, surface_, strength_, cut_off_);
  }
  template <int dim, class T>
  double constrained_modulus(const LawPoint<MohrCoulombLaw, dim, T>&) const {
    return elastic_.constrained_modulus();
  }
  const LinearElastic& elastic() const { return elastic_; }

 private:
  LinearElastic elastic_;
  MohrCoulombStrength<double> strength_;
  MohrCoulombReturn<double> surface_;
  bool cut_off_;
};

static_assert(StressLaw<MohrCoulombLaw, 2> && StressLaw<MohrCoulombLaw, 3>);

}  // namespace wetfront::mpm
