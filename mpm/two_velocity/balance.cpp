#include "mpm/laws/soil_water.h"
#include "mpm/two_velocity/blow_up.h"
#include "mpm/two_velocity/content.h"
#include "mpm/two_velocity/two_velocity.h"

#include <algorithm>

/// Steps IV and VI of the two-velocity scheme: mass balance of the liquid, pressure of the cells.
namespace wetfront::mpm {

/// Steps IV and VI: nodal Darcy flux, cell outflow, water of the points, pressure of the cells.
template <int dim>
void TwoVelocityLiquid<dim>::add_mass_balance(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  const Column& volume = plan.require_on_points("volume");
  blow_up_ = std::make_unique<BlowUp<dim>>(plan, w);
  // From here to the end of the step the column "liquid velocity" holds v_l - v_s.
  plan.add(Phase::strain, "Darcy flux", [&w, watch = blow_up_.get()] {
    watch->remember();
    for (std::size_t i = 0; i < w.flux->size(); ++i) {
      const Vector<dim> solid = w.skeleton->velocity(i);
      for (int a = 0; a < dim; ++a) {
        (*w.velocity)[a][i] -= solid[a];
        (*w.flux)[a][i] = (*w.content)[0][i] * (*w.velocity)[a][i];
      }
    }
    watch->examine();
  });
  const auto take = [this, &w, &plan, &volume](const Block& block, double outflow) {
    const double change = -plan.clock.dt * outflow / w.cells.volume[block.cell];
    for (std::size_t q = block.first; q < block.first + block.count; ++q)
      (*point_water_)[0][q] += change * volume[0][q];
  };
  if (plan.stage.mass_balance == MassBalance::conservative)
    plan.add_over_blocks(Phase::pressure, "mass balance",
                         [&w, take](const Block& block) { take(block, w.cells.flow_out(block, *w.flux)); });
  else
    plan.add_over_blocks(Phase::pressure, "mass balance as printed in 2021", [&w, take](const Block& block) {
      const double content = w.cells.water[block.cell] / w.cells.volume[block.cell];
      take(block, content * w.cells.flow_out(block, *w.velocity));
    });
  if (w.surface) add_rain_on_cut_surface(plan);
  add_pressure(plan);
}

/// Step VI for the cells behind a free surface: rain, and what does not fit.
template <int dim>
void TwoVelocityLiquid<dim>::add_rain_on_cut_surface(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  const Column& volume = plan.require_on_points("volume");
  auto first = std::make_shared<std::vector<Block>>(plan.fields.grid.cell_count());
  for (const Block& block : plan.fields.points.blocks()) (*first)[block.cell] = block;
  const auto held = [this, first](std::size_t cell) {
    const Block& block = (*first)[cell];
    double sum = 0;
    for (std::size_t q = block.first; q < block.first + block.count; ++q) sum += (*point_water_)[0][q];
    return sum;
  };
  const auto change = [this, &w, &volume, first](std::size_t cell, double water) {
    const Block& block = (*first)[cell];
    for (std::size_t q = block.first; q < block.first + block.count; ++q)
      (*point_water_)[0][q] += water * volume[0][q] / w.cells.volume[cell];
  };
  Column& outflow = plan.require_on_nodes("outflow");
  plan.add(Phase::pressure, "free surface", [&w, &plan, &outflow, held, change] {
    w.surface->rain(w, plan.clock.time, plan.clock.dt, held, change);
    for (const auto& piece : w.surface->pieces()) {
      const int* nodes = plan.fields.grid.cell_nodes_of(piece.cell);
      for (int i = 0; i < cell_nodes<dim>; ++i)
        outflow[0][nodes[i]] += piece.weight[static_cast<std::size_t>(i)] * piece.seeped;
    }
  });
}

/// Step VI: the pressure of a cell is the inverse of its water content.
template <int dim>
void TwoVelocityLiquid<dim>::add_pressure(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  for (std::size_t r = 0; r < plan.problem.soils.size(); ++r) {
    const Soil& soil = plan.problem.soils[r];
    with_soil_water(soil, *plan.problem.water, [&](const auto& laws) {
      const WaterContent law(laws.curve, plan.problem.water->bulk_modulus);
      const auto find = [this, &plan, &w, law, K = plan.problem.water->bulk_modulus](const Block& block) {
        double sum = 0;
        for (std::size_t q = block.first; q < block.first + block.count; ++q) sum += (*point_water_)[0][q];
        w.cells.water[block.cell] = sum;
        const double p = law.pressure_of(sum / w.cells.pores[block.cell]);
        // Water compressed by a tenth or drawn to half its density: no soil is there, the scheme has blown up.
        if (!(p < 0.1 * K && p > -0.5 * K))
          throw StepFailed("the two-velocity scheme has blown up: cell " + std::to_string(block.cell) + " at " +
                           place_text<dim>(w.cells.centre[block.cell]) + " holds " +
                           std::to_string(sum / w.cells.pores[block.cell]) +
                           " of its pores, which no pressure explains" + step_against_limit<dim>(plan, w));
        w.cells.pressure[block.cell] = p;
      };
      plan.add_over_blocks(Phase::pressure, "pressure of cells [" + soil.name + "]", static_cast<int>(r), find);
      plan.at_ready([&points = plan.fields.points, r, find] {
        for (const Block& block : points.blocks(static_cast<int>(r))) find(block);
      });
    });
  }
}

template void TwoVelocityLiquid<2>::add_mass_balance(StagePlan<2>&);
template void TwoVelocityLiquid<3>::add_mass_balance(StagePlan<3>&);
template void TwoVelocityLiquid<2>::add_rain_on_cut_surface(StagePlan<2>&);
template void TwoVelocityLiquid<3>::add_rain_on_cut_surface(StagePlan<3>&);
template void TwoVelocityLiquid<2>::add_pressure(StagePlan<2>&);
template void TwoVelocityLiquid<3>::add_pressure(StagePlan<3>&);

}  // namespace wetfront::mpm
