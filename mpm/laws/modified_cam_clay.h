#pragma once

#include "mpm/laws/linear_elastic.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::mpm {

/// Modified Cam-Clay (Roscoe & Burland 1968), p and volumetric strain compression-positive inside this file:
///
///     f = q^2/M^2 + p (p - p_c),  associated;   kappa: -de = kappa dp/p,  hardening: -de_p = (lambda - kappa)
///     dp_c/p_c,
///
/// G = 3 (1 - 2 nu)/(2 (1 + nu)) K with K = (1 + e) p/kappa, p not below `least_pressure` (where the line in e - ln p
/// continues straight). Backward Euler (Borja & Lee 1990) in e - ln p, so isotropic paths are exact for any step;
/// Newton's method in the plastic volumetric strain and the plastic multiplier, in as many parts of a step as keep it
/// safe.
///
/// The worked example of adding a law: this file, its parameters in problem.h (SkeletonLaw), a line in stress_laws.h.
class ModifiedCamClayLaw {
 public:
  /// 1. What a point remembers, by column; here p_c [Pa] and the void ratio.
  template <int dim>
  static constexpr int memory_size = 2;
  static constexpr bool needs_suction = false;
  static constexpr bool modulus_varies = true;  ///< constrained_modulus depends on the point: asked point by point
  static std::vector<ColumnSpec> memory_specs(int) {
    return {{"preconsolidation", "p_c", "Pa"}, {"void ratio", "e", "-"}};
  }

  ModifiedCamClayLaw(const Elastic& elastic, const ModifiedCamClay& spec)
      : spec_(spec), shear_share_(3 * (1 - 2 * elastic.poisson) / (2 * (1 + elastic.poisson))) {}

  /// 2. The memory of a point that has not been strained yet.
  template <int dim, class T>
  void begin(LawPoint<ModifiedCamClayLaw, dim, T>& point) const {
    point.memory = {T(spec_.preconsolidation), T(spec_.void_ratio)};
  }

  /// 3. Stress and memory over a step, for any number type: no branch on a value, `select` and `any` instead.
  template <int dim, class T>
  void advance(LawPoint<ModifiedCamClayLaw, dim, T>& point, const StepGradient<dim, T>& step) const {
    rotate<dim>(point.stress, step);
    const SymmetricTensor<dim, T> strain = strain_of(step);
    T size{};
    for (const T& part : strain) size = max(size, abs(part));
    // Trial pressures that change by more than a tenth of themselves slow Newton's method or lead it astray.
    const T wanted = size * ((1 + spec_.void_ratio) / spec_.swelling / 0.1);
    T parts(1.0);
    int most = 1;
    while (most < most_parts && any(wanted > double(most))) parts += select(wanted > double(most++), T(1.0), T(0.0));
    const T share = T(1.0) / parts;
    for (int part = 0; part < most; ++part) {
      SymmetricTensor<dim, T> taken = strain;
      for (T& component : taken) component = select(parts > double(part), component * share, T(0.0));
      take<dim>(point, taken);
    }
  }
  /// 4. The elastic constrained modulus at the point, for the time step.
  template <int dim, class T>
  double constrained_modulus(const LawPoint<ModifiedCamClayLaw, dim, T>& point) const {
    const double pressure = std::max(-trace<dim>(point.stress) / 3, spec_.least_pressure);
    return (1 + point.memory[1]) * pressure / spec_.swelling * (1 + shear_share_ * 4 / 3);
  }

 private:
  static constexpr int most_parts = 1000;

  /// The elastic line: ln p above the least pressure, straight on below it.
  template <class T>
  T line(const T& pressure) const {
    using std::log;
    const T relative = pressure * (1 / spec_.least_pressure);
    return select(relative > 1.0, log(max(relative, T(1.0))), relative - 1.0);
  }
  template <class T>
  T pressure_on(const T& place) const {
    using std::exp;
    return select(place > 0.0, exp(max(place, T(0.0))), place + 1.0) * spec_.least_pressure;
  }

  template <int dim, class T>
  void take(LawPoint<ModifiedCamClayLaw, dim, T>& point, const SymmetricTensor<dim, T>& strain) const {
    using std::exp;
    const T dilation = trace<dim>(strain), before = point.memory[1] + 1.0, after = before * exp(dilation);
    const T pressure = trace<dim>(point.stress) * (-1.0 / 3.0);
    const T place = line(pressure) + (before - after) * (1 / spec_.swelling);
    const T specific = (before + after) * 0.5, least(spec_.least_pressure), trial = pressure_on(place);
    const T shear = specific * (max(pressure, least) + max(trial, least)) * (0.5 * shear_share_ / spec_.swelling);
    SymmetricTensor<dim, T> deviator = point.stress;
    for (int k = 0; k < stress_components<dim>; ++k) deviator[k] += shear * strain[k] * 2.0;
    for (int k = 0; k < 3; ++k) deviator[k] += pressure - shear * dilation * (2.0 / 3.0);
    T square{};
    for (int k = 0; k < stress_components<dim>; ++k) square += deviator[k] * deviator[k] * (k < 3 ? 1.5 : 3.0);
    const Increment<T> end = plastic(place, sqrt(square), specific, shear, point.memory[0]);
    for (int k = 0; k < stress_components<dim>; ++k) point.stress[k] = deviator[k] * end.shrink;
    for (int k = 0; k < 3; ++k) point.stress[k] -= end.pressure;
    point.memory = {end.preconsolidation, after - 1.0};
  }

  template <class T>
  struct Increment {
    T pressure, preconsolidation, shrink;  ///< shrink: deviator over that of the trial
  };
  /// Newton's method in w (plastic volumetric strain) and y = p_c d(lambda). A point that does not converge is given a
  /// stress that is not a number, at which a run stops.
  template <class T>
  Increment<T> plastic(const T& place, const T& q, const T& specific, const T& shear, const T& pc) const {
    using std::exp;
    const double m2 = spec_.critical_slope * spec_.critical_slope;
    const T elastic_rate = specific * (1 / spec_.swelling),
            plastic_rate = specific * (1 / (spec_.compression - spec_.swelling));
    const T trial = pressure_on(place), scale = T(1.0) / pc, stiff = shear * scale * (6 / m2);
    const auto outside = q * q * (1 / m2) + trial * (trial - pc) > 0.0;
    Increment<T> end{trial, pc, T(1.0)};
    if (!any(outside)) return end;
    T w{}, y{};
    for (int turn = 0; turn < 60; ++turn) {
      const T p = pressure_on(place - elastic_rate * w), hard = pc * exp(plastic_rate * w),
              shrink = T(1.0) / (stiff * y + 1.0);
      const T slope = -elastic_rate * max(p, T(spec_.least_pressure)), hard_slope = hard * plastic_rate;
      const T flow = (p * 2.0 - hard) * scale, shear_part = q * q * shrink * shrink * scale * scale * (1 / m2);
      const T r1 = w - y * flow, r2 = shear_part + p * (p - hard) * scale * scale;
      end = {p, hard, shrink};
      const auto off = outside && (abs(r1) > abs(w) * 1e-14 + 1e-17 || abs(r2) > 1e-13);
      if (!any(off)) break;
      const T a = T(1.0) - y * (slope * 2.0 - hard_slope) * scale, b = -flow;
      const T c = (slope * (p * 2.0 - hard) - p * hard_slope) * scale * scale, d = shear_part * shrink * stiff * -2.0;
      const T determinant = a * d - b * c, most = T(1.0) / elastic_rate;
      w -= select(off, min(max((r1 * d - r2 * b) / determinant, -most), most), T(0.0));
      y = max(y - select(off, (r2 * a - r1 * c) / determinant, T(0.0)), T(0.0));
      if (turn == 59) end.pressure = select(off, T(std::numeric_limits<double>::quiet_NaN()), end.pressure);
    }
    end.pressure = select(outside, end.pressure, trial);
    end.preconsolidation = select(outside, end.preconsolidation, pc);
    end.shrink = select(outside, end.shrink, T(1.0));
    return end;
  }

  ModifiedCamClay spec_;
  double shear_share_;  ///< G/K
};

static_assert(StressLaw<ModifiedCamClayLaw, 2> && StressLaw<ModifiedCamClayLaw, 3>);

}  // namespace wetfront::mpm
