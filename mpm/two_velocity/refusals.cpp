#include "mpm/two_velocity/two_velocity.h"

#include <cmath>

/// What the two-velocity schemes cannot do: refused when the plan is made, by name.
namespace wetfront::mpm {

namespace {

constexpr const char* kind(const PressureSide&) {
  return "a prescribed pressure";
}
constexpr const char* kind(const FreeDrainageSide&) {
  return "free drainage";
}
constexpr const char* kind(const TotalHeadSide&) {
  return "a prescribed head";
}
constexpr const char* kind(const WaterLevelSide&) {
  return "a water level";
}
constexpr const char* kind(const FluxSide&) {
  return "a prescribed flux";
}
constexpr const char* kind(const PeriodicSides&) {
  return "a periodic partner";
}

const char* scheme_name(const Stage& stage) {
  return stage.liquid == LiquidScheme::explicit_drag ? "explicit" : "implicit-drag";
}

void refuse_boundary(const WaterBoundary& boundary, const std::string& who) {
  std::visit(
      [&who](const auto& b) {
        const std::string where = b.origin + ": side '" + b.side + "' has ";
        if constexpr (std::is_same_v<std::decay_t<decltype(b)>, RainSide>) {
          for (double demand : b.evaporation.intensity)
            if (demand > 0)
              throw CannotPlan(where + "evaporation, but " + who +
                               " (whose surface takes rain and lets water out where it is saturated, no more). Use the "
                               "scheme seepage, or leave the evaporation out");
        } else {
          throw CannotPlan(where + kind(b) + ", but " + who +
                           " (two velocities know rain, seepage faces and impermeable sides only). Use the scheme "
                           "seepage, or leave that boundary out");
        }
      },
      boundary);
}

void refuse_soil(const Soil& soil, const std::string& who) {
  const std::string where = soil.origin + ": soil '" + soil.name + "' has ";
  const auto& t = soil.anisotropy;
  if (t[0] != t[1] || t[1] != t[2] || t[3] != 0 || t[4] != 0 || t[5] != 0)
    throw CannotPlan(where + "an anisotropic permeability, but " + who +
                     " (its drag is one number per node). Use the scheme seepage");
  if (soil.storage)
    throw CannotPlan(
        where + "a storage coefficient of its own, but " + who +
        " (the pressure follows from the mass of a liquid of one compressibility). Leave `storage` out, or "
        "use the scheme seepage");
}

}  // namespace

template <int dim>
void TwoVelocityLiquid<dim>::refuse_what_it_cannot_do(const StagePlan<dim>& plan) const {
  const Problem<dim>& problem = plan.problem;
  const std::string who = "stage '" + plan.stage.name + "' uses the scheme " + scheme_name(plan.stage);
  for (const auto& boundary : problem.water_boundary) refuse_boundary(boundary, who);
  for (const Soil& soil : problem.soils) refuse_soil(soil, who);
  if (!std::isfinite(problem.water->bulk_modulus))
    throw CannotPlan(problem.water->origin + ": the water is incompressible, but " + who +
                     " (pressure waves would be infinitely fast: no step is short enough). Give it a bulk modulus, or "
                     "use the scheme seepage or semi-implicit");
  if (problem.rain_scheme != RainScheme::standard)
    throw CannotPlan(plan.stage.origin + ": a named variant of the rain boundary is asked for, but " + who +
                     " (which has the standard one only). Use rain scheme standard");
  for (const Soil& soil : problem.soils)
    if (soil.bishop != Bishop::saturation && soil.elastic)
      throw CannotPlan(soil.origin + ": soil '" + soil.name +
                       "' has the effective saturation as Bishop's parameter, but " + who +
                       " (whose pull on the skeleton knows the degree of saturation only)");
  for (const Block& block : plan.fields.points.blocks())
    if (plan.fields.grid.region(block.cell) != block.soil)
      throw CannotPlan(plan.stage.origin + ": " + who + ", but points of soil '" +
                       problem.soils[static_cast<std::size_t>(block.soil)].name +
                       "' have moved into the cells of another before (with two velocities the laws of water belong to "
                       "cells). Use the scheme seepage, or give both one soil");
  if (!problem.conductivity_factor.empty())
    throw CannotPlan(problem.soils.front().origin + ": the cells have conductivity factors of their own, but " + who +
                     " (it takes the permeability from the soil). Use the scheme seepage");
}

template void TwoVelocityLiquid<2>::refuse_what_it_cannot_do(const StagePlan<2>&) const;
template void TwoVelocityLiquid<3>::refuse_what_it_cannot_do(const StagePlan<3>&) const;

}  // namespace wetfront::mpm
