#include "mpm/seepage/seepage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace wetfront::mpm {

template <int dim>
void Seepage<dim>::provide_columns(StagePlan<dim>& plan) {
  const std::string volume = dim == 2 ? "m2" : "m3";
  const auto carried = [&](const char* name, const char* symbol, const std::string& unit) {
    return &plan.provide_on_nodes({name, symbol, unit});
  };
  const auto in_step = [&](const char* name, const char* symbol, const std::string& unit, int components = 1) {
    return &plan.provide_on_nodes({name, symbol, unit, components, Lifetime::step});
  };
  const bool fresh = plan.fields.grid.columns.find_allocated("pressure") == nullptr;
  columns_.pressure = carried("pressure", "p", "Pa");
  columns_.pressure_before = carried("pressure before", "p'", "Pa");
  columns_.pressure_earlier = carried("pressure earlier", "p''", "Pa");
  columns_.stored = carried("stored water", "W", volume);
  columns_.stored_before = carried("stored water before", "W'", volume);
  columns_.pore_volume = in_step("pore volume", "nV", volume, static_cast<int>(plan.problem.soils.size()));
  columns_.steps = &plan.provide_on_run({"seepage steps", "dt", "s", step_memory_entries});
  columns_.point_pressure = &plan.provide_on_points({"pressure", "p", "Pa"});
  columns_.point_saturation = &plan.provide_on_points({"saturation", "S", "-"});
  if (plan.stage.liquid == LiquidScheme::semi_implicit) {
    columns_.flux = &plan.provide_on_points({"flux", "q", "m/s", dim});
    if (skeleton_ != nullptr) {
      columns_.acceleration = &plan.provide_on_points({"skeleton acceleration", "a_s", "m/s2", dim});
      columns_.yielding = &plan.provide_on_points({"yielding water content", "nS*", "-", 1, Lifetime::step});
    }
  }
  water_->trial = in_step("trial pressure", "p*", "Pa");
  water_->stored = in_step("trial stored water", "W*", volume);
  water_->capacity = in_step("capacity", "dW/dp", volume + "/Pa");
  water_->inflow = in_step("inflow", "R", volume + "/s");
  water_->outflow = &water_->cumulate(plan, "outflow", "Q_out");
  if (fresh)
    plan.at_entry([&plan, p = columns_.pressure] { std::ranges::copy(plan.problem.initial_pressure, (*p)[0]); });
}

template <int dim>
void Seepage<dim>::prepare(StagePlan<dim>& plan) {
  if (skeleton_ != nullptr) return skeleton_->ready();
  const Column &volume = *plan.fields.points.columns.find("volume"),
               &value = *plan.fields.points.columns.find("shape value");
  columns_.pore_volume->fill(0);
  for (std::size_t region = 0; region < plan.problem.soils.size(); ++region)
    for (const Block& block : plan.fields.points.blocks(static_cast<int>(region)))
      for (std::size_t q = block.first; q < block.first + block.count; ++q)
        for (int i = 0; i < cell_nodes<dim>; ++i)
          (*columns_.pore_volume)[static_cast<int>(region)][block.nodes[i]] +=
              plan.problem.soils[region].porosity * volume[0][q] * value[i][q];
  build_matrix(plan);
  measure_cells(plan);
  step_->prepare();
}

template <int dim>
void Seepage<dim>::follow_points(StagePlan<dim>& plan, bool cells_changed) {
  if (cells_changed || water_->matrix == nullptr) build_matrix(plan);
  measure_cells(plan);
  step_->prepare();
  for (const auto& tell : water_->moved) tell();
}

template <int dim>
void Seepage<dim>::build_matrix(StagePlan<dim>& plan) {
  constexpr int n = cell_nodes<dim>;
  const auto& points = plan.fields.points;
  std::vector<std::pair<int, int>> couplings;
  for (std::size_t region = 0; region < plan.problem.soils.size(); ++region)
    for (const Block& block : points.blocks(static_cast<int>(region)))
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) couplings.emplace_back(block.nodes[i], block.nodes[j]);
  water_->ties.add_couplings(couplings);
  water_->matrix = std::make_unique<SparseSystem>(static_cast<int>(plan.fields.grid.node_count()), couplings);
  water_->ties.prepare(*water_->matrix, couplings);
  slots_.assign(plan.fields.grid.cell_count() * n * n, -1);
  for (const Block& block : points.blocks())
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        slots_[block.cell * n * n + static_cast<std::size_t>(i * n + j)] =
            water_->matrix->slot(block.nodes[i], block.nodes[j]);
}

template <int dim>
void Seepage<dim>::measure_cells(const StagePlan<dim>& plan) {
  const Problem<dim>& problem = plan.problem;
  const Column& volume = *plan.fields.points.columns.find("volume");
  for (auto& of_cells : mobility_) of_cells.assign(plan.fields.grid.cell_count(), 0.0);
  reach_.assign(plan.fields.points.slots(), 0.0);
  Stencil<dim> centre;
  for (const Block& block : plan.fields.points.blocks()) {
    const auto soil = static_cast<std::size_t>(block.soil);
    const double factor = problem.conductivity_factor.empty() ? 1 : problem.conductivity_factor[block.cell];
    mobility_[soil][block.cell] = factor * problem.soils[soil].intrinsic_permeability / problem.water->viscosity;
    const double cell = cell_nodes<dim> * plan.fields.grid.stencil(block.cell, Vector<dim>{}, centre);
    for (std::size_t q = block.first; q < block.first + block.count; ++q)
      reach_[q] = std::min(1.0, std::pow(volume[0][q] / cell, 1.0 / dim));
  }
}

template <int dim>
void Seepage<dim>::join(StagePlan<dim>& plan) {
  provide_columns(plan);
  double scale = std::numeric_limits<double>::infinity();
  for (const Soil& soil : plan.problem.soils) {
    const TabulatedSoilWater laws = tabulated_soil_water(soil, *plan.problem.water);
    soils_.push_back({SoilContent(soil, laws.curve, plan.problem.water->bulk_modulus), laws.permeability});
    scale = std::min(scale, laws.curve.pressure_scale());
    contents_.push_back(soils_.back().content);
  }
  mobility_.resize(soils_.size());
  if (skeleton_ != nullptr)
    skeleton_->join(plan, *water_, columns_, contents_, [this, &plan](bool changed) { follow_points(plan, changed); });
  add_storage(plan);
  add_flux(plan);
  step_ = std::make_unique<SeepageStep<dim>>(plan, *water_, columns_, scale);
  if (skeleton_ != nullptr) plan.add(Phase::pressure, "places of the points", [this] { skeleton_->begin_step(); });
  const bool in_true_time = skeleton_ != nullptr && skeleton_->in_true_time();
  if (in_true_time)
    plan.add(Phase::pressure, "Newton's method", [this] { step_->cover(); });
  else
    plan.add(Phase::pressure, "Newton's method and step control", [this] { step_->run(); });
  plan.at_ready([this, &plan] { prepare(plan); });
  if (skeleton_ != nullptr)
    add_moving_points(plan);
  else
    add_point_update(plan);
  add_ledger(plan);
  add_output(plan);
  plan.at_entry([this, &plan] { (*columns_.steps)[step_proposal][0] = plan.stage.end_time - plan.begin_time(); });
  // Measured (README section 7): steps grow with tolerance^{-1/3} (BDF2) from 170 at 1e-4; per step and point 1.5 us,
  // and per solve 4e-8 s nodes^1.5 for the sparse direct solver, four solves a step.
  const double order = plan.stage.integrator == TimeIntegrator::bdf2 ? 3 : 2;
  plan.expect_steps(170 * std::pow(1e-4 / plan.stage.time_tolerance, 1 / order));
  plan.expect_cost(1.5e-6 * static_cast<double>(plan.fields.points.size()) +
                   1.6e-7 * std::pow(static_cast<double>(plan.fields.grid.node_count()), 1.5));
  if (!in_true_time)
    plan.add_accuracy_limit("accuracy", "local error of p <= time_tolerance (extrapolation against BDF2)",
                            [this] { return step_->proposal(); });
  plan.at_record([this](double, meshes::FieldHistory& history) {
    history.counters["Newton iterations"] += static_cast<double>(std::exchange(step_->newton_iterations, 0));
    history.counters["rejected steps"] += static_cast<double>(std::exchange(step_->rejected_steps, 0));
    history.counters["jumps of pressure taken"] += static_cast<double>(std::exchange(step_->jumps_taken, 0));
    history.counters["failed Newton solves"] += static_cast<double>(std::exchange(step_->failed_solves, 0));
  });
}

template class Seepage<2>;
template class Seepage<3>;

}  // namespace wetfront::mpm
