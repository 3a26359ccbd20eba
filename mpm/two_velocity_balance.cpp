#include "mpm/soil_water.h"
#include "mpm/two_velocity.h"
#include "mpm/two_velocity_content.h"

/// Steps IV and VI of the two-velocity scheme: mass balance of the liquid, pressure of the cells.
namespace wetfront::mpm {

namespace {

/// sum_p V_p sum_i grad N_i . u_i over a cell: its outflow when u is the nodal flux.
template <int dim>
double divergence(const Block& block, const TwoVelocityCells<dim>& cells, const Column& u) {
  double sum = 0;
  for (int i = 0; i < cell_nodes<dim>; ++i)
    for (int a = 0; a < dim; ++a) sum += cells.gradient[block.cell][i][a] * u[a][block.nodes[i]];
  return sum;
}

}  // namespace

/// Steps IV and VI: nodal Darcy flux, cell outflow, water of the points, pressure of the cells.
template <int dim>
void TwoVelocityLiquid<dim>::add_mass_balance(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  const Column& volume = plan.require_on_points("volume");
  // From here to the end of the step the column "liquid velocity" holds v_l - v_s.
  plan.add(Phase::strain, "Darcy flux", [&w] {
    for (std::size_t i = 0; i < w.flux->size(); ++i) {
      const Vector<dim> solid = w.skeleton->velocity(i);
      for (int a = 0; a < dim; ++a) {
        (*w.velocity)[a][i] -= solid[a];
        (*w.flux)[a][i] = (*w.content)[0][i] * (*w.velocity)[a][i];
      }
    }
  });
  const auto take = [this, &w, &plan, &volume](const Block& block, double outflow) {
    w.cells.outflow[block.cell] = outflow;
    const double change = -plan.clock.dt * outflow / w.cells.volume[block.cell];
    for (std::size_t q = block.first; q < block.first + block.count; ++q)
      (*point_water_)[0][q] += change * volume[0][q];
  };
  if (plan.stage.mass_balance == MassBalance::conservative)
    plan.add_over_blocks(Phase::pressure, "mass balance",
                         [&w, take](const Block& block) { take(block, divergence<dim>(block, w.cells, *w.flux)); });
  else
    plan.add_over_blocks(Phase::pressure, "mass balance as printed in 2021", [&w, take](const Block& block) {
      const double content = w.cells.water[block.cell] / w.cells.volume[block.cell];
      take(block, content * divergence<dim>(block, w.cells, *w.velocity));
    });
  add_pressure(plan);
}

/// Step VI: the pressure of a cell is the inverse of its water content. Where points move, the cells are summed anew
/// first, with the points and pores they have at the end of the step.
template <int dim>
void TwoVelocityLiquid<dim>::add_pressure(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  if (moving_ != nullptr) plan.add(Phase::carry, "cell integrals after moving", [this, &plan] { sum_cells(plan); });
  for (std::size_t r = 0; r < plan.problem.soils.size(); ++r) {
    const Soil& soil = plan.problem.soils[r];
    with_soil_water(soil, *plan.problem.water, [&](const auto& laws) {
      const WaterContent law(laws.curve, plan.problem.water->bulk_modulus);
      const auto find = [this, &w, law, K = plan.problem.water->bulk_modulus](const Block& block) {
        double sum = 0;
        for (std::size_t q = block.first; q < block.first + block.count; ++q) sum += (*point_water_)[0][q];
        w.cells.water[block.cell] = sum;
        const double p = law.pressure_of(sum / w.cells.pores[block.cell]);
        // Water compressed by a tenth or drawn to half its density: no soil is there, the scheme has blown up.
        if (!(p < 0.1 * K && p > -0.5 * K))
          throw StepFailed("the two-velocity scheme has blown up: cell " + std::to_string(block.cell) + " holds " +
                           std::to_string(sum / w.cells.pores[block.cell]) +
                           " of its pores, which no pressure explains. Use a smaller step_safety");
        w.cells.pressure[block.cell] = p;
      };
      plan.add_over_blocks(w.pressures_in, "pressure of cells [" + soil.name + "]", static_cast<int>(r), find);
      plan.at_ready([&points = plan.fields.points, r, find] {
        for (const Block& block : points.blocks(static_cast<int>(r))) find(block);
      });
    });
  }
}

template void TwoVelocityLiquid<2>::add_mass_balance(StagePlan<2>&);
template void TwoVelocityLiquid<3>::add_mass_balance(StagePlan<3>&);
template void TwoVelocityLiquid<2>::add_pressure(StagePlan<2>&);
template void TwoVelocityLiquid<3>::add_pressure(StagePlan<3>&);

}  // namespace wetfront::mpm
