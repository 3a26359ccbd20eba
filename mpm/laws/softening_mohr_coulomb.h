#pragma once

#include "mpm/laws/mohr_coulomb.h"

namespace wetfront::mpm {

/// Plastic shear strain sqrt(2/3 e:e) between principal stresses of a trial and those it was brought back to,
/// e = deviator/(2 G).
template <class T>
T plastic_shear_strain(const std::array<T, 3>& trial, const std::array<T, 3>& returned, double shear) {
  const T x = trial[0] - returned[0], y = trial[1] - returned[1], z = trial[2] - returned[2];
  const T mean = (x + y + z) * (1.0 / 3.0);
  const T square = (x - mean) * (x - mean) + (y - mean) * (y - mean) + (z - mean) * (z - mean);
  return sqrt(square * (2.0 / 3.0)) * (0.5 / shear);
}

/// Mohr-Coulomb whose friction, cohesion, dilatancy and cut-off change linearly with the plastic shear strain gamma_p
/// from peak to residual values. Implicit: the stress lies on the surface of the gamma_p at the end of the step, found
/// by Illinois' variant of regula falsi (Dowell & Jarratt 1971) between none and all of the softening.
///
/// The law has no length of its own: where it softens, shear bands are as wide as a cell, and results depend on the
/// mesh unless `range` is scaled with it.
class SofteningMohrCoulombLaw {
 public:
  template <int dim>
  static constexpr int memory_size = 1;
  static constexpr bool needs_suction = false;
  static std::vector<ColumnSpec> memory_specs(int) { return {{"plastic shear strain", "gamma_p", "-"}}; }

  SofteningMohrCoulombLaw(const Elastic& elastic, const SofteningMohrCoulomb& spec)
      : elastic_(elastic),
        spec_(spec),
        peak_(strength_of(spec.peak)),
        residual_(strength_of(spec.residual)),
        cut_off_(has_cut_off(spec.peak) || has_cut_off(spec.residual)) {}

  template <int dim, class T>
  void begin(LawPoint<SofteningMohrCoulombLaw, dim, T>& point) const {
    point.memory[0] = T(0.0);
  }

  template <int dim, class T>
  void advance(LawPoint<SofteningMohrCoulombLaw, dim, T>& point, const StepGradient<dim, T>& step) const {
    rotate<dim>(point.stress, step);
    elastic_.add<dim>(point.stress, strain_of(step));
    const T before = point.memory[0];
    const MohrCoulombStrength<T> now = any(before > 0.0) ? strength(before) : everywhere<T>(peak_);
    if constexpr (dim == 3)
      if (!any(may_yield(point.stress, now, cut_off_))) return;
    Principal<dim, T> principal(point.stress);
    const MohrCoulombReturn<T> surface(now, elastic_.lame(), elastic_.shear_modulus());
    auto outside = surface.yield(principal.values[0], principal.values[2]) > 0.0;
    if (cut_off_) outside = outside || principal.values[0] > now.cut_off;
    if (!any(outside)) return;
    point.memory[0] = select(outside, soften(principal.values, before), before);
    const SymmetricTensor<dim, T> returned = principal.tensor();
    for (int k = 0; k < stress_components<dim>; ++k) point.stress[k] = select(outside, returned[k], point.stress[k]);
  }
  template <int dim, class T>
  double constrained_modulus(const LawPoint<SofteningMohrCoulombLaw, dim, T>&) const {
    return elastic_.constrained_modulus();
  }
  /// sin phi, 2 c cos phi and sin psi at a plastic shear strain.
  template <class T>
  MohrCoulombStrength<T> strength(const T& gamma) const {
    using std::cos, std::sin;
    const T share = min(max(gamma * (1.0 / spec_.range), T(0.0)), T(1.0));
    const auto between = [&share](double peak, double residual) { return share * (residual - peak) + peak; };
    const T friction = between(spec_.peak.friction, spec_.residual.friction);
    const T sine = sin(friction),
            cohesive = between(spec_.peak.cohesion, spec_.residual.cohesion) * cos(friction) * 2.0;
    const T apex = select(sine > 0.0, cohesive / (max(sine, T(1e-300)) * 2.0), T(std::numeric_limits<double>::max()));
    return {sine, cohesive, sin(between(spec_.peak.dilatancy, spec_.residual.dilatancy)),
            min(between(peak_.cut_off, residual_.cut_off), apex)};
  }

 private:
  template <class T>
  static MohrCoulombStrength<T> everywhere(const MohrCoulombStrength<double>& one) {
    return {T(one.sin_friction), T(one.cohesive), T(one.sin_dilatancy), T(one.cut_off)};
  }
  /// Brings trial values back to the surface of the plastic shear strain that doing so leaves, and says what that is.
  template <class T>
  T soften(std::array<T, 3>& values, const T& before) const {
    const std::array<T, 3> trial = values;
    const auto increment = [&](const T& gamma) {
      const MohrCoulombReturn<T> surface(strength(gamma), elastic_.lame(), elastic_.shear_modulus());
      values = cut_off_ ? surface.with_cut_off(trial) : surface.without_cut_off(trial);
      return plastic_shear_strain(trial, values, elastic_.shear_modulus());
    };
    const T least = increment(before);
    if (!any(before < spec_.range)) return before + least;
    const T most = max(least, increment(before + spec_.range));
    T low = before, high = before + most, excess_low = least, excess_high = increment(high) - most, middle = high;
    auto off = abs(excess_high) > most * 1e-12;
    // Three turns for the steps of a run; the bound is for numbers that are not finite. Who has arrived stays;
    // `values` are those of `middle`, the last that was asked for.
    for (int turn = 0; turn < 60 && any(off); ++turn) {
      const T width = select(off, excess_low - excess_high, T(1.0));
      middle = select(off, (high * excess_low - low * excess_high) / width, middle);
      const T excess = before + increment(middle) - middle;
      off = off && abs(excess) > most * 1e-12 + abs(middle) * 4e-16;
      const auto right = excess > 0.0;
      excess_high = select(right, excess_high * 0.5, excess);
      excess_low = select(right, excess, excess_low * 0.5);
      low = select(right, middle, low);
      high = select(right, high, middle);
    }
    return middle;
  }

  LinearElastic elastic_;
  SofteningMohrCoulomb spec_;
  MohrCoulombStrength<double> peak_, residual_;
  bool cut_off_;
};

static_assert(StressLaw<SofteningMohrCoulombLaw, 2> && StressLaw<SofteningMohrCoulombLaw, 3>);

}  // namespace wetfront::mpm
