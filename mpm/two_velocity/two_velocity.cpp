#include "mpm/two_velocity/two_velocity.h"

#include <algorithm>

namespace wetfront::mpm {

template <int dim>
void TwoVelocityLiquid<dim>::provide_columns(StagePlan<dim>& plan) {
  const std::string volume = dim == 2 ? "m2" : "m3";
  const auto in_step = [&](const char* name, const char* symbol, const std::string& unit, int components = 1) {
    return &plan.provide_on_nodes({name, symbol, unit, components, Lifetime::step});
  };
  TwoVelocityWater<dim>& w = *water_;
  w.volume = in_step("occupied volume", "V_i", volume);
  w.content = in_step("nodal water content", "nS", "-");
  w.velocity = in_step("liquid velocity", "v_l", "m/s", dim);
  w.velocity_new = in_step("new liquid velocity", "v_l*", "m/s", dim);
  w.force = in_step("liquid force", "F_l", "N", dim);
  w.mobility = in_step("mobility", "k k_rel/mu", "m2/(Pa s)");
  w.cell_mobility = in_step("mobility of cells", "k k_rel/mu", "m2/(Pa s)");
  w.offset = in_step("offset from cells", "x_i - x_c", "m", dim);
  w.pressure = &plan.provide_on_nodes({"pressure", "p", "Pa"});
  w.flux = &plan.provide_on_nodes({"Darcy flux", "w", "m/s", dim});
  w.rain_rate = &plan.provide_on_nodes({"rain rate", "I A", volume + "/s"});
  steps_ = &plan.provide_on_run({"two-velocity step", "dt", "s"});
  point_water_ = &plan.provide_on_points({"water", "W", volume});
  point_velocity_ = &plan.provide_on_points({"liquid velocity", "v_l", "m/s", dim});
}

/// Integrals over the cells and nodes from the points where they are now.
template <int dim>
void TwoVelocityLiquid<dim>::sum_cells(StagePlan<dim>& plan) {
  const auto& grid = plan.fields.grid;
  auto& points = plan.fields.points;
  const Column &shape = points.columns.at("shape value"), &slope = points.columns.at("shape gradient");
  const Column& volume = points.columns.at("volume");
  TwoVelocityWater<dim>& w = *water_;
  const Vector<dim> weight = liquid_weight(plan);
  w.volume->fill(0);
  w.offset->fill(0);
  for (const Block& block : points.blocks()) {
    const Soil& soil = plan.problem.soils[static_cast<std::size_t>(grid.region(block.cell))];
    double grains = 0;
    for (std::size_t q = block.first; q < block.first + block.count; ++q) grains += (1 - soil.porosity) * volume[0][q];
    w.cells.sum(grid, {volume, shape, slope, weight}, block, grains);
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      const double share = w.cells.share[block.cell][i];
      (*w.volume)[0][block.nodes[i]] += share;
      for (int a = 0; a < dim; ++a)
        (*w.offset)[a][block.nodes[i]] += share * (grid.node(block.nodes[i])[a] - w.cells.centre[block.cell][a]);
    }
  }
  for (std::size_t i = 0; i < grid.node_count(); ++i)
    if ((*w.volume)[0][i] > 0)
      for (int a = 0; a < dim; ++a) (*w.offset)[a][i] /= (*w.volume)[0][i];
}

template <int dim>
void TwoVelocityLiquid<dim>::join(StagePlan<dim>& plan) {
  refuse_what_it_cannot_do(plan);
  const ColumnSet& earlier = plan.fields.points.columns;
  const bool fresh = earlier.find_allocated("liquid velocity") == nullptr;
  carried_before_ = earlier.find_allocated("water") != nullptr;
  provide_columns(plan);
  if (fresh) plan.at_entry([this, &plan] { take_over(plan); });
  if (cycle_ != nullptr)
    join_moving(plan);
  else
    join_resting(plan);
  add_limits(plan);
  add_ledger(plan);
  add_output(plan);
}

template <int dim>
void TwoVelocityLiquid<dim>::join_resting(StagePlan<dim>& plan) {
  if (plan.stage.liquid == LiquidScheme::explicit_drag)
    water_->skeleton = std::make_unique<RestingSkeleton<dim, ExplicitDrag>>();
  else
    water_->skeleton = std::make_unique<RestingSkeleton<dim, ImplicitDrag>>();
  water_->block_pressure = [this](const Block& block) { return water_->cells.pressure[block.cell]; };
  plan.at_ready([this, &plan] {
    sum_cells(plan);
    if (water_->surface) water_->surface->attach(*water_);
  });
  add_gather(plan);
  add_momentum(plan);
  add_mass_balance(plan);
  add_state(plan);
  // Measured on the seed column, 80 points in 42 nodes: see README.md.
  plan.expect_cost(2e-6 + 3.5e-7 * static_cast<double>(plan.fields.points.size()));
}

/// rho_l g [N per m^dim of liquid]; zero where the scene has no gravity.
template <int dim>
Vector<dim> TwoVelocityLiquid<dim>::liquid_weight(const StagePlan<dim>& plan) const {
  Vector<dim> weight{};
  const Column* gravity = plan.fields.run.find("gravity");
  if (gravity != nullptr && !gravity->provided_by().empty())
    for (int a = 0; a < dim; ++a) weight[a] = water_->density * plan.problem.gravity[a];
  return weight;
}

template class TwoVelocityLiquid<2>;
template class TwoVelocityLiquid<3>;

}  // namespace wetfront::mpm
