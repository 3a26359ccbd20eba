#include "mpm/two_velocity.h"

#include "mpm/soil_water.h"
#include "mpm/two_velocity_content.h"
#include "mpm/water_ledger.h"

#include <algorithm>
#include <cmath>

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

template <int dim>
Vector<dim> at(const Column& column, std::size_t i) {
  Vector<dim> v{};
  for (int a = 0; a < dim; ++a) v[a] = column[a][i];
  return v;
}
template <int dim>
void put(Column& column, std::size_t i, const Vector<dim>& v) {
  for (int a = 0; a < dim; ++a) column[a][i] = v[a];
}

}  // namespace

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

/// Steps I to III: points to nodes, forces and drag, points from accelerations, velocities mapped back (MUSL).
template <int dim>
void TwoVelocityLiquid<dim>::add_momentum(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  auto& points = plan.fields.points;
  const Column& shape = plan.require_on_points("shape value");
  const std::size_t nodes = plan.fields.grid.node_count();
  // (nS)_i from the water of the points; it changes only with step VI.
  const auto content = [this, &w, &points, &shape, nodes] {
    w.content->fill(0);
    for (const Block& block : points.blocks())
      for (int i = 0; i < cell_nodes<dim>; ++i) {
        double sum = 0;
        for (std::size_t q = block.first; q < block.first + block.count; ++q)
          sum += shape[i][q] * (*point_water_)[0][q];
        (*w.content)[0][block.nodes[i]] += sum;
      }
    for (std::size_t i = 0; i < nodes; ++i)
      if ((*w.volume)[0][i] > 0) (*w.content)[0][i] /= (*w.volume)[0][i];
  };
  // Eq. 14: v_i = sum W v N / sum W N.
  from_points_ = [this, &w, &points, &shape, nodes] {
    w.velocity->fill(0);
    for (const Block& block : points.blocks()) {
      std::array<Vector<dim>, cell_nodes<dim>> momentum{};
      for (std::size_t q = block.first; q < block.first + block.count; ++q)
        for (int i = 0; i < cell_nodes<dim>; ++i) {
          const double mass = shape[i][q] * (*point_water_)[0][q];
          for (int a = 0; a < dim; ++a) momentum[i][a] += mass * (*point_velocity_)[a][q];
        }
      for (int i = 0; i < cell_nodes<dim>; ++i)
        for (int a = 0; a < dim; ++a) (*w.velocity)[a][block.nodes[i]] += momentum[i][a];
    }
    for (std::size_t i = 0; i < nodes; ++i) {
      if (!((*w.volume)[0][i] > 0)) continue;
      Vector<dim> v = at<dim>(*w.velocity, i);
      for (double& component : v) component /= (*w.content)[0][i] * (*w.volume)[0][i];
      w.walls.project(i, v);
      put<dim>(*w.velocity, i, v);
    }
  };
  plan.add(Phase::gather, "water of points to nodes", content);
  plan.add(Phase::gather, "liquid velocity of points to nodes", from_points_);
  plan.at_ready(content);

  Vector<dim> weight{};
  const Column* gravity = plan.fields.run.find("gravity");
  if (gravity != nullptr && !gravity->provided_by().empty())
    for (int a = 0; a < dim; ++a) weight[a] = w.density * plan.problem.gravity[a];
  forces_ = [&w, &points, weight, nodes] {
    for (int a = 0; a < dim; ++a)
      for (std::size_t i = 0; i < nodes; ++i) (*w.force)[a][i] = weight[a] * (*w.volume)[0][i];
    for (const Block& block : points.blocks())
      for (int i = 0; i < cell_nodes<dim>; ++i)
        for (int a = 0; a < dim; ++a)
          (*w.force)[a][block.nodes[i]] += w.cells.pressure[block.cell] * w.cells.gradient[block.cell][i][a];
  };
  plan.add(Phase::accelerate, "liquid forces", forces_);
  plan.add(Phase::accelerate, "implicit drag", [&w, &plan, nodes] {
    for (std::size_t i = 0; i < nodes; ++i) {
      if (!((*w.volume)[0][i] > 0)) continue;
      Vector<dim> v = w.driven(i, (*w.mobility)[0][i], plan.clock.dt);
      w.walls.project(i, v);
      put<dim>(*w.velocity_new, i, v);
    }
  });
  // Eq. 13, FLIP: points take the nodal increments.
  plan.add_over_blocks(Phase::point_velocity, "liquid velocity of points", [this, &w, &shape](const Block& block) {
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a) {
        const double change = (*w.velocity_new)[a][block.nodes[i]] - (*w.velocity)[a][block.nodes[i]];
        for (std::size_t q = block.first; q < block.first + block.count; ++q)
          (*point_velocity_)[a][q] += shape[i][q] * change;
      }
  });
  plan.add(Phase::point_velocity, "liquid velocity mapped back", from_points_);
}

/// Steps IV and VI: nodal Darcy flux, cell outflow, water of the points, pressure of the cells.
template <int dim>
void TwoVelocityLiquid<dim>::add_mass_balance(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  const Column& volume = plan.require_on_points("volume");
  plan.add(Phase::strain, "Darcy flux", [&w] {
    for (int a = 0; a < dim; ++a)
      for (std::size_t i = 0; i < w.flux->size(); ++i) (*w.flux)[a][i] = (*w.content)[0][i] * (*w.velocity)[a][i];
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
      plan.add_over_blocks(Phase::pressure, "pressure of cells [" + soil.name + "]", static_cast<int>(r), find);
      plan.at_ready([&points = plan.fields.points, r, find] {
        for (const Block& block : points.blocks(static_cast<int>(r))) find(block);
      });
    });
  }
}

template <int dim>
void TwoVelocityLiquid<dim>::sum_cells(const StagePlan<dim>& plan) {
  const auto& grid = plan.fields.grid;
  const auto& points = plan.fields.points;
  const auto& columns = points.columns;
  const Column &volume = *columns.find("volume"), &shape = *columns.find("shape value"),
               &gradient = *columns.find("shape gradient");
  TwoVelocityCells<dim>& cells = water_->cells;
  water_->volume->fill(0);
  water_->offset->fill(0);
  for (const Block& block : points.blocks()) {
    const std::size_t c = block.cell;
    const double porosity = plan.problem.soils[static_cast<std::size_t>(grid.region(c))].porosity;
    cells.volume[c] = 0;
    cells.share[c] = {};
    cells.gradient[c] = {};
    cells.size[c] = grid.smallest_altitude(c);
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      cells.volume[c] += volume[0][q];
      for (int i = 0; i < cell_nodes<dim>; ++i) {
        cells.share[c][i] += volume[0][q] * shape[i][q];
        for (int a = 0; a < dim; ++a) cells.gradient[c][i][a] += volume[0][q] * gradient[i * dim + a][q];
      }
    }
    cells.pores[c] = porosity * cells.volume[c];
    Vector<dim> centre{};
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a) centre[a] += cells.share[c][i] / cells.volume[c] * grid.node(block.nodes[i])[a];
    cells.centre[c] = centre;
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      (*water_->volume)[0][block.nodes[i]] += cells.share[c][i];
      for (int a = 0; a < dim; ++a)
        (*water_->offset)[a][block.nodes[i]] += cells.share[c][i] * (grid.node(block.nodes[i])[a] - centre[a]);
    }
  }
  for (std::size_t i = 0; i < grid.node_count(); ++i)
    if ((*water_->volume)[0][i] > 0)
      for (int a = 0; a < dim; ++a) (*water_->offset)[a][i] /= (*water_->volume)[0][i];
}

template <int dim>
void TwoVelocityLiquid<dim>::join(StagePlan<dim>& plan) {
  for (const auto& boundary : plan.problem.water_boundary)
    std::visit(
        [&plan](const auto& b) {
          if constexpr (!std::is_same_v<std::decay_t<decltype(b)>, RainSide>)
            throw CannotPlan(b.origin + ": side '" + b.side +
                             "' has a prescribed pressure or free drainage, but stage '" + plan.stage.name +
                             "' uses the scheme implicit-drag (two velocities know rain and impermeable sides only). "
                             "Use the scheme seepage, or leave that boundary out");
        },
        boundary);
  const Column* earlier = plan.fields.points.columns.find("water");
  const bool fresh = earlier == nullptr || !earlier->allocated();
  provide_columns(plan);
  if (fresh) plan.at_entry([this, &plan] { take_over(plan); });
  plan.at_ready([this, &plan] { sum_cells(plan); });
  add_momentum(plan);
  add_mass_balance(plan);
  add_state(plan);
  add_limits(plan);
  add_ledger(plan);
  add_output(plan);
  // Measured on the seed column, 80 points in 42 nodes: see TWO_VELOCITY.md.
  plan.expect_cost(1e-6 + 1.5e-7 * static_cast<double>(plan.fields.points.size()));
}

template class TwoVelocityLiquid<2>;
template class TwoVelocityLiquid<3>;

}  // namespace wetfront::mpm
