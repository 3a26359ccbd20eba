#include "mpm/laws/soil_water.h"
#include "mpm/record/water_ledger.h"
#include "mpm/seepage/soil_content.h"
#include "mpm/two_velocity/content.h"
#include "mpm/two_velocity/two_velocity.h"

#include <algorithm>
#include <limits>
#include <sstream>

/// How the two-velocity scheme takes over the water, and what it writes into ledger and snapshots.
namespace wetfront::mpm {

/// Water of the points at the start of the stage.
///
/// From the initial state of a problem the cells take the pressure at their centre, so that a hydrostatic start rests.
/// From `seepage` they take its water, sum_i share_ci n e(p_i), so that the hand-over neither makes nor loses any (the
/// lumped nodes and the cells hold the same sum, to the tolerance of Newton's method there).
template <int dim>
void TwoVelocityLiquid<dim>::take_over(StagePlan<dim>& plan) {
  const auto& columns = plan.fields.grid.columns;
  const Column* seepage = columns.find_allocated("stored water");
  const bool after_seepage = seepage != nullptr;
  if (!after_seepage)
    std::copy(plan.problem.initial_pressure.begin(), plan.problem.initial_pressure.end(), (*water_->pressure)[0]);
  const auto& points = plan.fields.points;
  const double before = !after_seepage ? 0 : carried_before_ ? points.sum(*point_water_) : seepage->sum();
  const Column& volume = *points.columns.find("volume");
  std::vector<Taker> takers;
  for (std::size_t r = 0; r < plan.problem.soils.size(); ++r)
    with_soil_water(plan.problem.soils[r], *plan.problem.water, [&](const auto& laws) {
      const WaterContent law(laws.curve, plan.problem.water->bulk_modulus);
      // The very content that seepage balanced, table and all.
      const SoilContent of_seepage(plan.problem.soils[r],
                                   tabulated_soil_water(plan.problem.soils[r], *plan.problem.water).curve,
                                   plan.problem.water->bulk_modulus);
      for (const Block& block : points.blocks(static_cast<int>(r))) {
        const auto weights = centre_weights(plan, block);
        double pressure = 0, content = 0;
        for (int i = 0; i < cell_nodes<dim>; ++i) {
          const double p = (*water_->pressure)[0][block.nodes[i]];
          pressure += weights[i] * p;
          if (after_seepage) content += weights[i] * of_seepage.at(p).value;
        }
        if (!after_seepage) content = law.value(pressure);
        if (carried_before_)
          fit_full_cell(plan, block, content, law, takers);
        else
          for (std::size_t q = block.first; q < block.first + block.count; ++q)
            (*point_water_)[0][q] = laws.porosity * content * volume[0][q];
      }
    });
  if (carried_before_) give_back(plan, points.sum(*point_water_) - before, takers);
  // A body that moves takes its liquid along.
  if (const Column* solid = points.columns.find("velocity"); cycle_ != nullptr && solid != nullptr)
    std::ranges::copy(solid->values(), point_velocity_->values().begin());
  if (!after_seepage) {
    // What is recorded of the start is the state given, not what the cells make of it.
    plan.at_begin([this, &plan] { std::ranges::copy(plan.problem.initial_pressure, (*water_->pressure)[0]); });
    return;
  }
  plan.at_begin([this, &plan, before] {
    start_as_darcy(plan);
    std::ostringstream text;
    text << "stage '" << plan.stage.name << "' took over the water of seepage: " << before << " m3/m at the nodes, "
         << plan.fields.points.sum(*point_water_) - before << " m3/m more in the points";
    hand_over_ = text.str();
    hand_over_change_ = plan.fields.points.sum(*point_water_) - before;
  });
}

/// Points that have carried their water keep it, but where the cell is full: there their own tells their pressure badly
/// (1e-4 of it is 2e4 Pa), and the nodes' pressures have held the balance of forces. In between the one passes into the
/// other. What keeps its own can take some of what full cells have too much or too little of.
template <int dim>
template <class Law>
void TwoVelocityLiquid<dim>::fit_full_cell(const StagePlan<dim>& plan, const Block& block, double content,
                                           const Law& law, std::vector<Taker>& takers) {
  constexpr double nearly_full = 0.01;  // in S, as for points in seepage (coupling/carried_water.cpp)
  const double own = std::clamp((law.saturated() - content) / nearly_full, 0.0, 1.0);
  const auto& columns = plan.fields.points.columns;
  const Column &grains = *columns.find("mass"), &volume = *columns.find("volume");
  const double density = plan.problem.soils[static_cast<std::size_t>(block.soil)].grain_density;
  double held = 0, pores = 0;
  for (std::size_t q = block.first; q < block.first + block.count; ++q) {
    double& water = (*point_water_)[0][q];
    const double room = volume[0][q] - grains[0][q] / density;
    water += (1 - own) * (room * content - water);
    held += water;
    pores += room;
  }
  const double p = own > 0 ? law.pressure_of(held / pores) : 0;
  if (p < 0) takers.push_back({block, own * law.slope(p), own * pores * law.slope(p)});
}

/// `change`: water that full cells were given, > 0, by taking their nodes' pressures. The cells that are not full give
/// it, all at one pressure, as far as that is next to nothing: what the body holds stays what it was.
template <int dim>
void TwoVelocityLiquid<dim>::give_back(const StagePlan<dim>& plan, double change, const std::vector<Taker>& takers) {
  constexpr double next_to_nothing = 10;  // Pa: a thousandth of a metre of water
  double capacity = 0;
  for (const Taker& taker : takers) capacity += taker.capacity;
  if (!(capacity > 0)) return;
  const double fall = std::clamp(change / capacity, -next_to_nothing, next_to_nothing);
  const auto& columns = plan.fields.points.columns;
  const Column &grains = *columns.find("mass"), &volume = *columns.find("volume");
  for (const Taker& taker : takers) {
    const Block& block = taker.block;
    const double density = plan.problem.soils[static_cast<std::size_t>(block.soil)].grain_density;
    for (std::size_t q = block.first; q < block.first + block.count; ++q)
      (*point_water_)[0][q] -= fall * taker.slope * (volume[0][q] - grains[0][q] / density);
  }
}

/// sum_p V_p N_i / sum_p V_p over a cell: linear fields are interpolated exactly at the centre of its points.
template <int dim>
std::array<double, cell_nodes<dim>> TwoVelocityLiquid<dim>::centre_weights(const StagePlan<dim>& plan,
                                                                           const Block& block) const {
  // The stencils of the points are filled when the stage is ready, later than this.
  const auto& grid = plan.fields.grid;
  const Column& volume = *plan.fields.points.columns.find("volume");
  std::array<double, cell_nodes<dim>> weights{};
  double total = 0;
  Stencil<dim> s;
  for (std::size_t q = block.first; q < block.first + block.count; ++q) {
    grid.stencil(block.cell, grid.local(block.cell, plan.fields.points.position(q)), s);
    total += volume[0][q];
    for (int i = 0; i < cell_nodes<dim>; ++i) weights[i] += volume[0][q] * s.value[i];
  }
  for (double& weight : weights) weight /= total;
  return weights;
}

/// Liquid velocities of Darcy's law at the pressures taken over: the balance of forces and drag without inertia.
template <int dim>
void TwoVelocityLiquid<dim>::start_as_darcy(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  if (moving_)
    moving_->add_force();
  else
    forces_();
  for (std::size_t i = 0; i < plan.fields.grid.node_count(); ++i) {
    if (!((*w.volume)[0][i] > 0)) continue;
    Vector<dim> v{};
    for (int a = 0; a < dim; ++a)
      v[a] =
          (*w.force)[a][i] / (*(moving_ ? w.flow_volume : w.volume))[0][i] * (*w.mobility)[0][i] / (*w.content)[0][i];
    w.walls.project(i, v);
    for (int a = 0; a < dim; ++a) {
      (*w.velocity)[a][i] = v[a];
      (*w.flux)[a][i] = (*w.content)[0][i] * v[a];
    }
  }
  const auto& grid = plan.fields.grid;
  const Column* solid = cycle_ != nullptr ? plan.fields.points.columns.find("velocity") : nullptr;
  Stencil<dim> s;
  for (const Block& block : plan.fields.points.blocks())
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      grid.stencil(block.cell, grid.local(block.cell, plan.fields.points.position(q)), s);
      for (int a = 0; a < dim; ++a) {
        (*point_velocity_)[a][q] = solid != nullptr ? (*solid)[a][q] : 0.0;
        for (int i = 0; i < cell_nodes<dim>; ++i)
          (*point_velocity_)[a][q] += s.value[i] * (*w.velocity)[a][block.nodes[i]];
      }
    }
  if (moving_) moving_->sum();  // their momentum
}

/// Stored water twice: from the points, which carry it, and from the pressures of the cells, which drive the flow.
template <int dim>
void TwoVelocityLiquid<dim>::add_ledger(StagePlan<dim>& plan) {
  Column& ledger = plan.provide_on_run(water_ledger_spec());
  Column& outflow = plan.provide_on_nodes({"outflow", "Q_out", dim == 2 ? "m2" : "m3"});
  const auto begin = [this, &plan, &ledger, &outflow] {
    ledger[ledger_stored][0] = moving_ ? moving_->stored() : 0;
    ledger[ledger_stored_points][0] = moving_ ? moving_->held() : plan.fields.points.sum(*point_water_);
    ledger[ledger_outflow][0] = outflow.sum();
  };
  plan.add(Phase::carry, "water ledger", begin);
  plan.at_begin(begin);
  for (std::size_t r = 0; r < plan.problem.soils.size() && !moving_; ++r) {
    const Soil& soil = plan.problem.soils[r];
    with_soil_water(soil, *plan.problem.water, [&](const auto& laws) {
      const WaterContent law(laws.curve, plan.problem.water->bulk_modulus);
      const auto add = [this, law, &ledger](const Block& block) {
        const auto& cells = water_->cells;
        ledger[ledger_stored][0] += cells.pores[block.cell] * law.value(cells.pressure[block.cell]);
      };
      plan.add_over_blocks(Phase::carry, "water of cells [" + soil.name + "]", static_cast<int>(r), add);
      plan.at_begin([&points = plan.fields.points, r, add] {
        for (const Block& block : points.blocks(static_cast<int>(r))) add(block);
      });
    });
  }
  plan.at_record([this](double, meshes::FieldHistory& history) { tell_hand_over(history); });
  plan.at_finish([this](meshes::FieldHistory& history) { tell_hand_over(history); });
}

template <int dim>
void TwoVelocityLiquid<dim>::tell_hand_over(meshes::FieldHistory& history) {
  if (hand_over_.empty() || history.counters.contains("hand-over: stored water change")) return;
  history.log.push_back(hand_over_);
  history.counters["hand-over: stored water change"] = hand_over_change_;
}

template <int dim>
void TwoVelocityLiquid<dim>::add_output(StagePlan<dim>& plan) {
  std::vector<std::function<double(double)>> saturation;
  for (const Soil& soil : plan.problem.soils) saturation.push_back(saturation_of(soil, *plan.problem.water));
  plan.at_output([this, &plan, saturation](meshes::Snapshot& out) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const auto& grid = plan.fields.grid;
    const auto& points = plan.fields.points;
    const Column& p_node = *water_->pressure;
    out.node_pressure.assign(p_node[0], p_node[0] + grid.node_count());
    out.node_saturation.assign(grid.node_count(), nothing);
    out.cells_hold_averages = true;
    out.cell_pressure.assign(grid.cell_count(), nothing);
    out.cell_saturation.assign(grid.cell_count(), nothing);
    out.points.pressure.assign(points.size(), nothing);
    out.points.saturation.assign(points.size(), nothing);
    auto next_pressure = out.points.pressure.begin(), next_saturation = out.points.saturation.begin();
    for (const Block& block : points.blocks()) {
      const auto& law = saturation[static_cast<std::size_t>(block.soil)];
      const double p = water_->block_pressure(block), s = law(p);
      out.cell_pressure[block.cell] = p;
      out.cell_saturation[block.cell] = s;
      next_pressure = std::fill_n(next_pressure, block.count, p);
      next_saturation = std::fill_n(next_saturation, block.count, s);
      for (int i = 0; i < cell_nodes<dim>; ++i)
        out.node_saturation[static_cast<std::size_t>(block.nodes[i])] = law(p_node[0][block.nodes[i]]);
    }
  });
}

#define WETFRONT_INSTANTIATE(d)                                                                                      \
  template void TwoVelocityLiquid<d>::take_over(StagePlan<d>&);                                                      \
  template std::array<double, cell_nodes<d>> TwoVelocityLiquid<d>::centre_weights(const StagePlan<d>&, const Block&) \
      const;                                                                                                         \
  template void TwoVelocityLiquid<d>::start_as_darcy(StagePlan<d>&);                                                 \
  template void TwoVelocityLiquid<d>::add_ledger(StagePlan<d>&);                                                     \
  template void TwoVelocityLiquid<d>::tell_hand_over(meshes::FieldHistory&);                                         \
  template void TwoVelocityLiquid<d>::add_output(StagePlan<d>&);
WETFRONT_INSTANTIATE(2)
WETFRONT_INSTANTIATE(3)
#undef WETFRONT_INSTANTIATE

}  // namespace wetfront::mpm
