#include "mpm/plan/check_skeleton.h"

#include "mpm/plan/want.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wetfront::mpm {

namespace {

constexpr double right_angle = std::numbers::pi / 2;

struct LawCheck {
  const Soil& soil;
  std::string of = " of soil '" + soil.name + "'";

  void operator()(const MohrCoulomb& law) const {
    if (!(law.friction >= 0 && law.friction < right_angle))
      refuse(law.origin, "friction angle" + of, law.friction, "it has to lie between 0 and pi/2");
    if (!(law.dilatancy > -right_angle && law.dilatancy <= law.friction))
      refuse(law.origin, "dilatancy angle" + of, law.dilatancy,
             "above the friction angle flow would make work out of nothing");
    want_at_least(law.origin, "cohesion" + of, law.cohesion, 0);
    if (law.friction == 0) want_positive(law.origin, "cohesion" + of + ", which has no friction,", law.cohesion);
    if (law.tension_cut_off) want_at_least(law.origin, "tension cut-off" + of, *law.tension_cut_off, 0);
  }
  void operator()(const SofteningMohrCoulomb& law) const {
    (*this)(law.peak);
    (*this)(law.residual);
    want_positive(law.peak.origin, "softening range" + of, law.range);
  }
  void operator()(const SuctionMohrCoulomb& law) const {
    (*this)(law.saturated);
    want_at_least(law.saturated.origin, "cohesion by suction" + of, law.suction_cohesion, 0);
    want_at_least(law.saturated.origin, "rate of cohesion" + of, law.cohesion_rate, 0);
    want_at_least(law.saturated.origin, "rate of friction" + of, law.friction_rate, 0);
  }
  void operator()(const ModifiedCamClay& law) const {
    want_positive(law.origin, "critical slope" + of, law.critical_slope);
    want_positive(law.origin, "swelling" + of, law.swelling);
    if (!(law.compression > law.swelling && std::isfinite(law.compression)))
      refuse(law.origin, "compression" + of, law.compression, "it has to exceed swelling");
    want_positive(law.origin, "void ratio" + of, law.void_ratio);
    want_positive(law.origin, "preconsolidation" + of, law.preconsolidation);
    want_positive(law.origin, "least pressure" + of, law.least_pressure);
  }
  void operator()(const NeoHookean&) const {}
  void operator()(const Hencky&) const {}
};

void check_soil(const Soil& soil) {
  const std::string of = " of soil '" + soil.name + "'";
  if (!soil.elastic) {
    if (soil.law)
      throw CannotPlan(soil.origin + ": soil '" + soil.name +
                       "' has strength but no stiffness (a rigid skeleton does not fail). Give it `elastic`");
    return;
  }
  want_positive(soil.elastic->origin, "Young's modulus" + of, soil.elastic->young);
  if (!(soil.elastic->poisson > -1 && soil.elastic->poisson < 0.5))
    refuse(soil.elastic->origin, "Poisson's ratio" + of, soil.elastic->poisson, "it has to lie between -1 and 0.5");
  want_positive(soil.origin, "grain density" + of, soil.grain_density);
  if (soil.law) std::visit(LawCheck{soil}, *soil.law);
  if (soil.earth_pressure_at_rest)
    want_at_least(soil.origin, "earth pressure at rest" + of, *soil.earth_pressure_at_rest, 0);
}

struct SideCheck {
  void operator()(const Traction& b) const {
    check_record(b.origin, "load", b.factor);
    for (double value : {b.pressure, b.force[0], b.force[1], b.force[2]})
      if (!std::isfinite(value)) refuse(b.origin, "a load", value, "it has to be finite");
  }
  void operator()(const MovingSide& b) const {
    check_record(b.origin, "velocity", b.factor);
    for (const auto& value : b.velocity)
      if (value && !std::isfinite(*value)) refuse(b.origin, "a velocity", *value, "it has to be finite");
  }
  void operator()(const FrictionalContact& b) const { want_at_least(b.origin, "friction of the base", b.friction, 0); }
  void operator()(const AbsorbingSide&) const {}
  void operator()(const PeriodicSkeleton&) const {}
};

void check_stage(const Stage& stage) {
  const std::string of = " of stage '" + stage.name + "'";
  want_positive(stage.origin, "unbalanced ratio" + of, stage.relaxation.unbalanced_ratio);
  want_between(stage.origin, "relaxation damping" + of, stage.relaxation.damping, 0, 1);
  want_positive(stage.origin, "coupling tolerance" + of, stage.relaxation.coupling_tolerance);
  if (!(stage.local_damping >= 0 && stage.local_damping < 1))
    refuse(stage.origin, "local damping" + of, stage.local_damping, "it has to be 0 or more and below 1");
}

}  // namespace

template <int dim>
void check_skeleton(const Problem<dim>& problem) {
  for (const Soil& soil : problem.soils) check_soil(soil);
  for (const auto& side : problem.skeleton_boundary) std::visit(SideCheck{}, side);
  for (const Stage& stage : problem.stages) check_stage(stage);
  if (!(problem.skeleton.pic >= 0 && problem.skeleton.pic <= 1))
    refuse("", "the share of PIC", problem.skeleton.pic, "it has to lie between 0 and 1");
  if (problem.threads < 1) refuse("", "the number of threads", problem.threads, "one is the least");
  const bool rigid = std::ranges::none_of(problem.soils, [](const Soil& soil) { return soil.elastic.has_value(); });
  if (rigid && !problem.skeleton_boundary.empty())
    throw CannotPlan(std::visit([](const auto& side) { return side.origin; }, problem.skeleton_boundary.front()) +
                     ": a load, contact or motion on a side of a rigid skeleton (nothing would move). Give the soils "
                     "`elastic`, or remove it");
  if (rigid && (problem.initial_stress != InitialStress::none || problem.initial_velocity || problem.body_acceleration))
    throw CannotPlan(
        "an initial stress, velocity or body acceleration of a rigid skeleton (nothing would move). Give "
        "the soils `elastic`, or remove it");
  if (problem.initial_velocity && problem.stages.front().motion == SkeletonMotion::quasi_static)
    throw CannotPlan(
        problem.stages.front().origin +
        ": an initial velocity is given, but the first stage is quasi-static "
        "(it goes from equilibrium to equilibrium, so the velocity would be lost). Let the skeleton move in "
        "true time, or remove it");
}

template void check_skeleton(const Problem<2>&);
template void check_skeleton(const Problem<3>&);

}  // namespace wetfront::mpm
