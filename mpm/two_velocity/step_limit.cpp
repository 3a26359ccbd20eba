#include "mpm/laws/soil_water.h"
#include "mpm/two_velocity/content.h"
#include "mpm/two_velocity/pressure_operator.h"
#include "mpm/two_velocity/two_velocity.h"

#include <algorithm>
#include <cmath>
#include <limits>

/// Step limits of the two-velocity schemes (README.md section 6).
namespace wetfront::mpm {

namespace {

/// A step may grow by this factor over the last one, so that the look-ahead of the limit (below) cannot be outrun.
constexpr double growth = 1.5;
/// Steps that the limit looks ahead at the present rate of filling.
constexpr double steps_ahead = 4;

}  // namespace

/// Geometric stiffness of the cells of a resting body, and how much drag mapping leaves.
template <int dim>
void TwoVelocityLiquid<dim>::find_stiffness(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  w.stiffness = w.cells.stiffness;
  plan.at_ready([&plan, &w] {
    using Geometry = PressureOperator<dim>;
    Geometry geometry(plan, w);
    double least = std::numeric_limits<double>::infinity();
    // Both scales bound; the one that lets the worst cell take the longer step is kept.
    for (const auto scale : {Geometry::Scale::mapped, Geometry::Scale::unmapped}) {
      geometry.scale_by(scale);
      const auto dragged = geometry.bound(Geometry::Drag::ruling);
      const auto worst = static_cast<std::size_t>(std::max_element(dragged.begin(), dragged.end()) - dragged.begin());
      if (dragged[worst] >= least) continue;
      least = dragged[worst];
      w.stiffness = geometry.bound(Geometry::Drag::none);
      w.mapping = w.stiffness[worst] / dragged[worst];  // one factor for all cells
    }
  });
}

template <int dim>
template <class Drag>
void TwoVelocityLiquid<dim>::add_pressure_limit(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  for (std::size_t r = 0; r < plan.problem.soils.size(); ++r) {
    const Soil& soil = plan.problem.soils[r];
    with_soil_water(soil, *plan.problem.water, [&](const auto& laws) {
      const WaterContent law(laws.curve, plan.problem.water->bulk_modulus);
      const auto of_cell = [this, &plan, &w, law](const Block& block) {
        const std::size_t c = block.cell;
        const TwoVelocityCells<dim>& cells = w.cells;
        double least = std::numeric_limits<double>::infinity(), most = 0, wet = 0, rain = 0;
        for (int i = 0; i < cell_nodes<dim>; ++i) {
          const auto node = static_cast<std::size_t>(block.nodes[i]);
          const double content = (*w.content)[0][node];
          if (!w.walls.closed(node)) {
            const double drag = content / ((*w.mobility)[0][node] * w.density);
            least = std::min(least, drag);
            most = std::max(most, drag);
            wet = std::max(wet, content);
          }
          rain += (*w.rain_rate)[0][node] * cells.share[c][i] / (*w.volume)[0][node];
        }
        if (w.surface) rain += w.surface->rain_on(c, plan.clock.time);
        const double pores = cells.pores[c] / cells.volume[c];
        const auto stable = [&](double slope) {
          return Drag::stable_step(least, most, w.mapping, w.stiffness[c] * wet / (pores * slope) / w.density);
        };
        const double now = stable(law.slope(cells.pressure[c]));
        // A cell near saturation stiffens 1e4-fold within a step: the limit is that of the stiffest state it can reach.
        const double last = (*steps_)[0][0];
        const double rate = std::max(std::abs(cells.flow_out(block, *w.flux)), rain) / cells.pores[c];
        const double ahead = cells.water[c] / cells.pores[c] + steps_ahead * rate * (last > 0 ? growth * last : now);
        const double p_ahead = ahead >= law.saturated() ? 0.0 : law.pressure_of(ahead);
        return std::min(now, stable(law.slope(p_ahead)));
      };
      plan.add_stability_limit("drag and pressure wave [" + soil.name + "]",
                               std::string(Drag::limit) +
                                   ", r = nS mu/(k k_rel rho_l), w^2 = K nS/(C rho_l), C = nS/K_l + n dS/dp, K <= "
                                   "4/h^2 of the cell matrices",
                               [&points = plan.fields.points, &w, r, of_cell] {
                                 double least = std::numeric_limits<double>::infinity();
                                 for (const Block& block : points.blocks(static_cast<int>(r)))
                                   least = std::min(least, of_cell(block));
                                 return w.limit_of_soil[r] = least;
                               });
    });
  }
}

template <int dim>
void TwoVelocityLiquid<dim>::add_limits(StagePlan<dim>& plan) {
  water_->limit_of_soil.assign(plan.problem.soils.size(), std::numeric_limits<double>::infinity());
  if (moving_)
    add_coupled_limit(plan);
  else
    add_resting_limit(plan);
  plan.add_accuracy_limit("growth", "1.5 x the step before", [this] {
    const double last = (*steps_)[0][0];
    return last > 0 ? growth * last : std::numeric_limits<double>::infinity();
  });
  plan.add(Phase::carry, "step length", [this, &plan] { (*steps_)[0][0] = plan.clock.dt; });
}

template <int dim>
void TwoVelocityLiquid<dim>::add_resting_limit(StagePlan<dim>& plan) {
  find_stiffness(plan);
  if (plan.stage.liquid == LiquidScheme::explicit_drag)
    add_pressure_limit<ExplicitDrag>(plan);
  else
    add_pressure_limit<ImplicitDrag>(plan);
}

/// Skeleton and liquid together (coupled_limit.h).
template <int dim>
void TwoVelocityLiquid<dim>::add_coupled_limit(StagePlan<dim>& plan) {
  for (std::size_t r = 0; r < plan.problem.soils.size(); ++r)
    plan.add_stability_limit(
        "skeleton, pressure wave and drag [" + plan.problem.soils[r].name + "]",
        "1/s with 4 M s^2 + 2 D s - K singular: two degrees of freedom per cell, E_oed, C = nS/K_l + n dS/dp, drag",
        [this, r] {
          const double least = moving_->limit(static_cast<int>(r), steps_ahead, growth, (*steps_)[0][0]);
          return water_->limit_of_soil[r] = least;
        });
}

template void TwoVelocityLiquid<2>::add_limits(StagePlan<2>&);
template void TwoVelocityLiquid<3>::add_limits(StagePlan<3>&);

}  // namespace wetfront::mpm
