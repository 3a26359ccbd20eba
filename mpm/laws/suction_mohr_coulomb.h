#pragma once

#include "mpm/laws/mohr_coulomb.h"

namespace wetfront::mpm {

/// Mohr-Coulomb with strength from suction s (Yerro, Alonso & Pinyol 2015, Eqs 20 and 21):
/// c = c' + c_max (1 - exp(-B s/p_atm)), phi = phi' + A s/p_atm, p_atm = 100 kPa. Wetting without strain brings the
/// stress back to the smaller surface. The friction angle is held below 80 degrees, beyond any soil.
class SuctionMohrCoulombLaw : public NoMemory {
 public:
  static constexpr bool needs_suction = true;
  static constexpr double atmosphere = 100e3;  ///< Pa
  static constexpr double largest_friction = 80 * 3.14159265358979323846 / 180;

  SuctionMohrCoulombLaw(const Elastic& elastic, const SuctionMohrCoulomb& spec)
      : elastic_(elastic), spec_(spec), cut_off_(spec.saturated.tension_cut_off.has_value()) {}

  template <int dim, class T>
  void advance(LawPoint<SuctionMohrCoulombLaw, dim, T>& point, const StepGradient<dim, T>& step) const {
    rotate<dim>(point.stress, step);
    elastic_.add<dim>(point.stress, strain_of(step));
    const MohrCoulombStrength<T> now = strength(point.suction);
    const MohrCoulombReturn<T> surface(now, elastic_.lame(), elastic_.shear_modulus());
    return_to_surface<dim>(point.stress, surface, now, cut_off_);
  }
  template <int dim, class T>
  double constrained_modulus(const LawPoint<SuctionMohrCoulombLaw, dim, T>&) const {
    return elastic_.constrained_modulus();
  }
  template <class T>
  MohrCoulombStrength<T> strength(const T& suction) const {
    using std::cos, std::exp, std::sin;
    const T relative = max(suction, T(0.0)) * (1 / atmosphere);
    const T cohesion =
        (T(1.0) - exp(relative * -spec_.cohesion_rate)) * spec_.suction_cohesion + spec_.saturated.cohesion;
    const T friction = min(relative * spec_.friction_rate + spec_.saturated.friction, T(largest_friction));
    const T sine = sin(friction), cohesive = cohesion * cos(friction) * 2.0;
    const T apex = select(sine > 0.0, cohesive / (max(sine, T(1e-300)) * 2.0), T(std::numeric_limits<double>::max()));
    return {sine, cohesive, T(std::sin(spec_.saturated.dilatancy)),
            cut_off_ ? min(T(*spec_.saturated.tension_cut_off), apex) : apex};
  }

 private:
  LinearElastic elastic_;
  SuctionMohrCoulomb spec_;
  bool cut_off_;
};

static_assert(StressLaw<SuctionMohrCoulombLaw, 2> && StressLaw<SuctionMohrCoulombLaw, 3>);

}  // namespace wetfront::mpm
