#include "mpm/coupling/strength_reduction.h"

#include "mpm/plan/carried_state.h"
#include "mpm/plan/derive_effects.h"
#include "mpm/plan/want.h"

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {

namespace {

/// First step of the factor above one, doubled until the body fails.
constexpr double first_step = 0.1;

struct Weaken {
  const Soil& soil;
  double factor;

  double angle(double of) const { return std::atan(std::tan(of) / factor); }
  MohrCoulomb operator()(MohrCoulomb law) const {
    law.friction = angle(law.friction);
    law.dilatancy = angle(law.dilatancy);
    law.cohesion /= factor;
    return law;
  }
  SofteningMohrCoulomb operator()(SofteningMohrCoulomb law) const {
    law.peak = (*this)(law.peak);
    law.residual = (*this)(law.residual);
    return law;
  }
  SuctionMohrCoulomb operator()(SuctionMohrCoulomb law) const {
    if (law.friction_rate != 0)
      refuse("friction that grows with suction", "its tangent over a factor is no angle plus a rate any more");
    law.saturated = (*this)(law.saturated);
    law.suction_cohesion /= factor;
    return law;
  }
  SkeletonLaw operator()(const ModifiedCamClay&) const {
    refuse("Cam-Clay", "its strength is no friction and cohesion");
  }
  SkeletonLaw operator()(const NeoHookean&) const { refuse("an elastic law", "it has no strength"); }
  SkeletonLaw operator()(const Hencky&) const { refuse("an elastic law", "it has no strength"); }

  [[noreturn]] void refuse(const std::string& what, const std::string& why) const {
    throw CannotPlan(soil.origin + ": soil '" + soil.name + "' has " + what +
                     ", but a factor of safety is asked for (" + why + "). Give it Mohr-Coulomb's strength");
  }
};

}  // namespace

Soil weakened(const Soil& soil, double factor) {
  const Weaken weaken{soil, factor};
  if (!soil.elastic || !soil.law) weaken.refuse("no strength", "there is nothing to divide");
  Soil weak = soil;
  weak.law = std::visit([&weaken](const auto& law) { return SkeletonLaw(weaken(law)); }, *soil.law);
  return weak;
}

namespace {

enum class Trial { stands, stalls, fails };

template <int dim>
Trial attempt(const Problem<dim>& problem, const State& state, double factor) {
  Problem<dim> weak = problem;
  for (Soil& soil : weak.soils) soil = weakened(soil, factor);
  weak.stages[state.stage].ends_with = StageEnd::failure;
  Fields<dim> fields(weak);
  restore_points(fields, state.fields);
  const auto plan = make_plan_of_weakened_rest(weak, state.stage, fields);
  plan->clock.time = plan->clock.end = plan->clock.event = state.time;
  plan->resume(state.fields);
  try {
    plan->run_step();
  } catch (const StepFailed&) {  // SkeletonFailed, or forces without bound
    return Trial::fails;
  }
  meshes::FieldHistory told;
  plan->record(state.time, told);
  return told.counters["stalled relaxations"] > 0 ? Trial::stalls : Trial::stands;
}

template <int dim>
void check(const Problem<dim>& problem, const State& state, const SafetySearch& search) {
  const Stage& stage = problem.stages.at(state.stage);
  if (stage.motion != SkeletonMotion::quasi_static)
    throw CannotPlan(stage.origin + ": a factor of safety is asked for in stage '" + stage.name +
                     "', which is not quasi-static (a body in motion has none). Ask for it in one that is");
  want_between(stage.origin, "tolerance of the factor of safety", search.tolerance, 0, 1);
  want_at_least(stage.origin, "largest factor of safety", search.largest, 1 + first_step);
}

}  // namespace

template <int dim>
SafetyFactor factor_of_safety(const Problem<dim>& problem, const State& state, const SafetySearch& search) {
  check(problem, state, search);
  const double start = thread_cpu_seconds();
  SafetyFactor found;
  const auto fails = [&](double factor) {
    const Trial trial = attempt(problem, state, factor);
    ++found.trials;
    found.stalled += trial == Trial::stalls;
    (trial == Trial::fails ? found.fails : found.stands) = factor;
    return trial == Trial::fails;
  };
  for (double step = first_step; found.stands < search.largest; step *= 2)
    if (fails(std::min(found.stands + step, search.largest))) break;
  while (found.fails > 0 && found.fails - found.stands > search.tolerance) fails(0.5 * (found.stands + found.fails));
  found.cpu_seconds = thread_cpu_seconds() - start;
  return found;
}

template SafetyFactor factor_of_safety(const Problem<2>&, const State&, const SafetySearch&);
template SafetyFactor factor_of_safety(const Problem<3>&, const State&, const SafetySearch&);

}  // namespace wetfront::mpm
