#include "mpm/plan/estimate.h"

#include "mpm/laws/soil_water.h"
#include "mpm/plan/derive_effects.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace wetfront::mpm {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Suction at which a soil just conducts what falls on it [Pa]; 0 from K_s on. Bisection in the logarithm.
template <int dim>
double wetted_suction(const Problem<dim>& problem, const Soil& soil, double intensity) {
  double suction = 0, gravity = 0;
  for (double g : problem.gravity) gravity += g * g;
  with_soil_water(soil, *problem.water, [&](const auto& laws) {
    const double saturated = laws.saturated_mobility * problem.water->density * std::sqrt(gravity);
    if (intensity >= saturated) return;
    double wet = 1e-3 * laws.curve.pressure_scale(), dry = 1e6 * laws.curve.pressure_scale();
    for (int i = 0; i < 60; ++i) {
      const double middle = std::sqrt(wet * dry);
      (saturated * laws.permeability(laws.curve, middle).value > intensity ? wet : dry) = middle;
    }
    suction = wet;
  });
  return suction;
}

/// Horizontal area of a side of the mesh; of the whole mesh where the side is none of it [m^(dim-1)].
template <int dim>
double horizontal_area(const meshes::Mesh& mesh, const std::string& name) {
  constexpr int corners = dim == 2 ? 2 : 4;
  double area = 0, left = infinity, right = -infinity;
  for (const auto& side : mesh.sides)
    if (side.name == name)
      for (std::size_t f = 0; f + corners <= side.faces.size(); f += corners) {
        const auto x = [&](int k, int axis) { return mesh.nodes[static_cast<std::size_t>(side.faces[f + k])][axis]; };
        if constexpr (dim == 2)
          area += std::abs(x(1, 0) - x(0, 0));
        else
          area += 0.5 * std::abs((x(2, 0) - x(0, 0)) * (x(3, 1) - x(1, 1)) - (x(3, 0) - x(1, 0)) * (x(2, 1) - x(0, 1)));
      }
  if (area > 0) return area;
  for (const auto& node : mesh.nodes) left = std::min(left, node[0]), right = std::max(right, node[0]);
  return right - left;
}

/// What the boundaries bring.
struct Wetting {
  double intensity = 0;         ///< the strongest rain [m/s]; infinite where a pressure is prescribed
  std::vector<double> suction;  ///< of the wetted state, per soil [Pa]
  double full_at = infinity;    ///< when the front has wetted all soil and water begins to stand [s]
};

/// Water that brings all soil from its initial state to at least the wetted one of each region [m^dim].
template <int dim>
double missing_water(const StagePlan<dim>& plan, const std::vector<double>& suction) {
  const Problem<dim>& problem = plan.problem;
  const Column& volume = *plan.fields.points.columns.find("volume");
  double missing = 0;
  for (std::size_t r = 0; r < problem.soils.size(); ++r)
    with_soil_water(problem.soils[r], *problem.water, [&](const auto& laws) {
      const double wetted = laws.saturation(-suction[r]);
      for (const Block& block : plan.fields.points.blocks(static_cast<int>(r))) {
        double lacks = 0, cell = 0;
        for (int i = 0; i < cell_nodes<dim>; ++i)
          lacks += std::max(
              0.0, wetted - laws.saturation(problem.initial_pressure[static_cast<std::size_t>(block.nodes[i])]));
        for (std::size_t q = block.first; q < block.first + block.count; ++q) cell += volume[0][q];
        missing += laws.porosity * cell * lacks / cell_nodes<dim>;
      }
    });
  return missing;
}

template <int dim>
Wetting wetting(const StagePlan<dim>& plan) {
  Wetting out;
  bool closed = true;
  std::vector<std::pair<const meshes::RainRecord*, double>> rains;
  for (const auto& boundary : plan.problem.water_boundary) {
    const auto* rain = std::get_if<RainSide>(&boundary);
    if (rain == nullptr || !rain->evaporation.start.empty()) closed = false;
    if (rain != nullptr) {
      rains.emplace_back(&rain->rain, horizontal_area<dim>(plan.problem.mesh, rain->side));
      for (double i : rain->rain.intensity) out.intensity = std::max(out.intensity, i);
    } else if (!std::holds_alternative<FreeDrainageSide>(boundary) &&
               !std::holds_alternative<PeriodicSides>(boundary)) {
      out.intensity = infinity;
    }
  }
  for (const Soil& soil : plan.problem.soils) out.suction.push_back(wetted_suction(plan.problem, soil, out.intensity));
  if (!closed || !(out.intensity > 0)) return out;
  const auto fallen = [&](double time) {
    double sum = 0;
    for (const auto& [rain, area] : rains) sum += area * meshes::depth_until(*rain, time);
    return sum;
  };
  const double missing = missing_water(plan, out.suction);
  double before = 0, after = plan.stage.end_time;
  if (fallen(after) < missing) return out;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (before + after);
    (fallen(middle) < missing ? before : after) = middle;
  }
  out.full_at = after;
  return out;
}

/// The limit of the stage, safety included, when it starts with the soil at least as wet as at a suction per region. At
/// rest and without rain, so that nothing is anticipated that the state itself does not hold.
template <int dim>
double limit_when_wet(const StagePlan<dim>& plan, const std::vector<double>& suction) {
  Problem<dim> wet = plan.problem;
  std::vector<double> most(wet.mesh.node_count(), -infinity);
  constexpr int corners = cell_nodes<dim>;
  for (std::size_t cell = 0; cell < wet.mesh.cell_count(); ++cell)
    for (int i = 0; i < corners; ++i) {
      double& p = most[static_cast<std::size_t>(wet.mesh.cells[cell * corners + static_cast<std::size_t>(i)])];
      p = std::max(p, -suction[static_cast<std::size_t>(wet.mesh.region[cell])]);
    }
  for (std::size_t i = 0; i < most.size(); ++i) wet.initial_pressure[i] = std::max(wet.initial_pressure[i], most[i]);
  for (auto& boundary : wet.water_boundary)
    if (auto* rain = std::get_if<RainSide>(&boundary))
      std::fill(rain->rain.intensity.begin(), rain->rain.intensity.end(), 0.0);
  Fields<dim> fields(wet);
  const auto made = make_plan(wet, plan.index(), fields);
  made->enter();
  return made->stable_step();
}

}  // namespace

template <int dim>
StageEstimate estimate(const StagePlan<dim>& plan) {
  StageEstimate out;
  const double begin = plan.begin_time(), end = plan.stage.end_time;
  const double cap = plan.stage.largest_step > 0 ? plan.stage.largest_step : infinity;
  out.step = std::min(cap, plan.stable_step());
  out.steps = std::max(plan.expected_steps(), (end - begin) / out.step);
  if (plan.conditionally_stable() && plan.stage.liquid) {
    out.by_limit = true;
    const Wetting water = wetting(plan);
    const std::vector<double> as_it_is(water.suction.size(), infinity), full(water.suction.size(), 0.0);
    out.step = std::min(cap, limit_when_wet(plan, as_it_is));
    if (water.intensity > 0) out.step = std::min(out.step, limit_when_wet(plan, water.suction));
    const double turn = std::clamp(water.full_at, begin, end);
    out.steps = (turn - begin) / out.step;
    if (turn < end) {
      const double step = std::min(cap, limit_when_wet(plan, full));
      out.steps += (end - turn) / step;
      out.step = turn > begin ? std::min(out.step, step) : step;
    }
  }
  out.cpu_seconds = out.steps * plan.expected_cost();
  return out;
}

/// Two velocities and moving skeletons have a limit of stability; only they can be refused for their cost.
template <int dim>
bool may_have_limit(const Problem<dim>& problem, const Stage& stage) {
  const bool moves = std::any_of(problem.soils.begin(), problem.soils.end(), [](const Soil& s) { return s.elastic; });
  return moves || stage.liquid == LiquidScheme::implicit_drag || stage.liquid == LiquidScheme::explicit_drag;
}

template <int dim>
void check_cost(const Problem<dim>& problem) {
  const bool any = std::any_of(problem.stages.begin(), problem.stages.end(),
                               [&](const Stage& stage) { return may_have_limit(problem, stage); });
  if (!(problem.cpu_budget > 0) || !any) return;
  Fields<dim> fields(problem);
  double total = 0;
  for (std::size_t stage = 0; stage < problem.stages.size(); ++stage) {
    const auto plan = make_plan(problem, stage, fields);
    plan->enter();
    if (!plan->conditionally_stable()) continue;
    const StageEstimate cost = estimate(*plan);
    total += cost.cpu_seconds;
    if (total <= problem.cpu_budget) continue;
    char text[256];
    std::snprintf(text, sizeof text,
                  "too expensive: about %.2g steps of dt = %.2g s, about %.2g h of CPU; budget %.3g s. ", cost.steps,
                  cost.step, total / 3600, problem.cpu_budget);
    throw CannotPlan(plan->stage.origin + ": stage '" + plan->stage.name + "': " + text +
                     (plan->stage.liquid ? "Use the scheme seepage, or a shorter window or a larger budget"
                                         : "Use a shorter stage or a larger budget"));
  }
}

template StageEstimate estimate(const StagePlan<2>&);
template StageEstimate estimate(const StagePlan<3>&);
template void check_cost(const Problem<2>&);
template void check_cost(const Problem<3>&);

}  // namespace wetfront::mpm
