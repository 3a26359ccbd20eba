#include "mpm/seepage/seepage.h"

#include "mpm/grid/cell_values.h"
#include "mpm/laws/soil_water.h"
#include "mpm/record/water_ledger.h"
#include "mpm/skeleton/rigid_skeleton.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::mpm {

namespace {

/// Water per pore volume of a soil at pressure p, and its slope: S, plus linear storage S_max p/K_l above p = 0.
template <class Laws>
ValueAndSlope water_content(const Laws& laws, double bulk_modulus, double p) {
  if (p > 0) return {laws.curve.s_max() * (1 + p / bulk_modulus), laws.curve.s_max() / bulk_modulus};
  return {laws.curve.saturation(-p), -laws.curve.slope(-p)};
}

/// What drives Darcy's flux: grad p alone, or grad p - rho g where the scene has gravity.
template <int dim>
struct PressureOnly {
  void operator()(Vector<dim>&) const {}
};
template <int dim>
struct PressureAndWeight {
  Vector<dim> weight;  ///< rho g [Pa/m]
  void operator()(Vector<dim>& gradient) const {
    for (int a = 0; a < dim; ++a) gradient[a] -= weight[a];
  }
};

/// Darcy flux of the points of a block: R_i -= V_p grad N_i . (k k_rel/mu)(grad p - rho g), with its derivative.
template <int dim, class Laws, class Driving>
struct DarcyFlux {
  NodalWater<dim>& water;
  const std::vector<int>& slots;
  const Column &volume, &value, &gradient;
  Laws laws;
  Driving driving;

  void operator()(const Block& block) const {
    constexpr int n = cell_nodes<dim>;
    std::array<double, n> p_node{}, flow{};
    std::array<double, n * n> slope{};
    for (int i = 0; i < n; ++i) p_node[i] = (*water.trial)[0][block.nodes[i]];
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      std::array<double, n> shape{}, along{};
      std::array<Vector<dim>, n> grad{};
      Vector<dim> drive{};
      double p = 0;
      for (int i = 0; i < n; ++i) {
        shape[i] = value[i][q];
        p += shape[i] * p_node[i];
        for (int a = 0; a < dim; ++a) {
          grad[i][a] = gradient[i * dim + a][q];
          drive[a] += grad[i][a] * p_node[i];
        }
      }
      driving(drive);
      const ValueAndSlope relative = laws.permeability(laws.curve, -p);
      const double scale = volume[0][q] * laws.saturated_mobility;
      const double mobility = scale * relative.value, mobility_slope = -scale * relative.slope;
      for (int i = 0; i < n; ++i) {
        for (int a = 0; a < dim; ++a) along[i] += grad[i][a] * drive[a];
        flow[i] -= mobility * along[i];
      }
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          double stiffness = 0;
          for (int a = 0; a < dim; ++a) stiffness += grad[i][a] * grad[j][a];
          slope[i * n + j] -= mobility * stiffness + mobility_slope * shape[j] * along[i];
        }
    }
    const auto matrix = water.matrix->values();
    for (int i = 0; i < n; ++i) (*water.inflow)[0][block.nodes[i]] += flow[i];
    for (int k = 0; k < n * n; ++k) matrix[static_cast<std::size_t>(slots[block.cell * n * n + k])] += slope[k];
  }
};

}  // namespace

template <int dim>
void Seepage<dim>::provide_columns(StagePlan<dim>& plan) {
  const std::string volume = dim == 2 ? "m2" : "m3";
  const auto carried = [&](const char* name, const char* symbol, const std::string& unit) {
    return &plan.provide_on_nodes({name, symbol, unit});
  };
  const auto in_step = [&](const char* name, const char* symbol, const std::string& unit, int components = 1) {
    return &plan.provide_on_nodes({name, symbol, unit, components, Lifetime::step});
  };
  const Column* earlier_pressure = plan.fields.grid.columns.find("pressure");
  const bool fresh = earlier_pressure == nullptr || !earlier_pressure->allocated();
  columns_.pressure = carried("pressure", "p", "Pa");
  columns_.pressure_before = carried("pressure before", "p'", "Pa");
  columns_.pressure_earlier = carried("pressure earlier", "p''", "Pa");
  columns_.stored = carried("stored water", "W", volume);
  columns_.stored_before = carried("stored water before", "W'", volume);
  columns_.pore_volume = in_step("pore volume", "nV", volume, static_cast<int>(plan.problem.soils.size()));
  columns_.steps = &plan.provide_on_run({"seepage steps", "dt", "s", step_memory_entries});
  columns_.point_pressure = &plan.provide_on_points({"pressure", "p", "Pa"});
  columns_.point_saturation = &plan.provide_on_points({"saturation", "S", "-"});
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
  constexpr int n = cell_nodes<dim>;
  const auto& points = plan.fields.points;
  const Column &volume = *plan.fields.points.columns.find("volume"),
               &value = *plan.fields.points.columns.find("shape value");
  columns_.pore_volume->fill(0);
  std::vector<std::pair<int, int>> couplings;
  for (std::size_t region = 0; region < plan.problem.soils.size(); ++region)
    for (const Block& block : points.blocks(static_cast<int>(region))) {
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) couplings.emplace_back(block.nodes[i], block.nodes[j]);
      for (std::size_t q = block.first; q < block.first + block.count; ++q)
        for (int i = 0; i < n; ++i)
          (*columns_.pore_volume)[static_cast<int>(region)][block.nodes[i]] +=
              plan.problem.soils[region].porosity * volume[0][q] * value[i][q];
    }
  water_->matrix = std::make_unique<SparseSystem>(static_cast<int>(plan.fields.grid.node_count()), couplings);
  slots_.assign(plan.fields.grid.cell_count() * n * n, -1);
  for (const Block& block : points.blocks())
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        slots_[block.cell * n * n + static_cast<std::size_t>(i * n + j)] =
            water_->matrix->slot(block.nodes[i], block.nodes[j]);
  step_->prepare();
}

template <int dim>
void Seepage<dim>::add_terms(StagePlan<dim>& plan) {
  const Water& liquid = *plan.problem.water;
  const Column &volume = plan.require_on_points("volume"), &value = plan.require_on_points("shape value"),
               &gradient = plan.require_on_points("shape gradient");
  const Column* gravity = plan.fields.run.find("gravity");
  const bool weighs = gravity != nullptr && !gravity->provided_by().empty();
  PressureAndWeight<dim> driving{plan.problem.gravity};
  for (double& component : driving.weight) component *= liquid.density;
  for (std::size_t r = 0; r < plan.problem.soils.size(); ++r) {
    const int region = static_cast<int>(r);
    const Soil& soil = plan.problem.soils[r];
    with_soil_water(soil, liquid, [&](const auto& laws) {
      using Laws = std::decay_t<decltype(laws)>;
      const auto storage = [this, laws, region, K = liquid.bulk_modulus] {
        const double *pores = (*columns_.pore_volume)[region], *p = (*water_->trial)[0];
        double *stored = (*water_->stored)[0], *capacity = (*water_->capacity)[0];
        for (std::size_t i = 0; i < columns_.pressure->size(); ++i) {
          if (!(pores[i] > 0)) continue;
          const ValueAndSlope content = water_content(laws, K, p[i]);
          stored[i] += pores[i] * content.value;
          capacity[i] += pores[i] * content.slope;
        }
      };
      water_->terms.push_back(&plan.add_iterated(Phase::pressure, "storage [" + soil.name + "]", storage));
      const auto add_flux = [&](auto drive) {
        DarcyFlux<dim, Laws, decltype(drive)> flux{*water_, slots_, volume, value, gradient, laws, drive};
        const auto body = [&points = plan.fields.points, region, flux] {
          for (const Block& block : points.blocks(region)) flux(block);
        };
        water_->terms.push_back(&plan.add_iterated(Phase::pressure, "Darcy flux [" + soil.name + "]", body));
      };
      if (weighs)
        add_flux(driving);
      else
        add_flux(PressureOnly<dim>{});
    });
  }
}

template <int dim>
void Seepage<dim>::add_point_update(StagePlan<dim>& plan) {
  const Column &volume = plan.require_on_points("volume"), &value = plan.require_on_points("shape value");
  Column& ledger = plan.require_on_run("water ledger");
  const auto clear = [&ledger] { ledger[ledger_stored_points][0] = 0; };
  plan.add(Phase::saturation, "clear point sums", clear);
  plan.at_begin(clear);
  for (std::size_t r = 0; r < plan.problem.soils.size(); ++r) {
    const int region = static_cast<int>(r);
    const Soil& soil = plan.problem.soils[r];
    with_soil_water(soil, *plan.problem.water, [&](const auto& laws) {
      const auto update = [this, laws, &volume, &value, &ledger,
                           K = plan.problem.water->bulk_modulus](const Block& block) {
        double water = 0;
        for (std::size_t q = block.first; q < block.first + block.count; ++q) {
          double p = 0;
          for (int i = 0; i < cell_nodes<dim>; ++i) p += value[i][q] * (*columns_.pressure)[0][block.nodes[i]];
          (*columns_.point_pressure)[0][q] = p;
          (*columns_.point_saturation)[0][q] = laws.saturation(p);
          water += volume[0][q] * laws.porosity * water_content(laws, K, p).value;
        }
        ledger[ledger_stored_points][0] += water;
      };
      plan.add_over_blocks(Phase::saturation, "points from nodes [" + soil.name + "]", region, update);
      plan.at_begin([&points = plan.fields.points, region, update] {
        for (const Block& block : points.blocks(region)) update(block);
      });
    });
  }
}

template <int dim>
void Seepage<dim>::add_ledger(StagePlan<dim>& plan) {
  Column& ledger = plan.provide_on_run(water_ledger_spec());
  Column& outflow = plan.require_on_nodes("outflow");
  const auto sum = [](const Column& column) {
    double total = 0;
    for (double value : column.values()) total += value;
    return total;
  };
  const auto write = [this, &ledger, &outflow, sum] {
    ledger[ledger_stored][0] = sum(*columns_.stored);
    ledger[ledger_outflow][0] = sum(outflow);
  };
  plan.add(Phase::carry, "water ledger", write);
  // The first nodal storage of the stage: W(p) of the pressures it starts from.
  plan.at_begin([this, write] {
    std::ranges::copy(columns_.pressure->values(), water_->trial->values().begin());
    water_->stored->fill(0);
    for (Kernel* term : water_->terms)
      if (term->name().starts_with("storage")) term->run();
    std::ranges::copy(water_->stored->values(), columns_.stored->values().begin());
    write();
  });
}

template <int dim>
void Seepage<dim>::add_output(StagePlan<dim>& plan) {
  std::vector<std::function<double(double)>> saturation;
  for (const Soil& soil : plan.problem.soils) saturation.push_back(saturation_of(soil, *plan.problem.water));
  plan.at_output([this, &plan, saturation](meshes::Snapshot& out) {
    const auto& grid = plan.fields.grid;
    const double* p = (*columns_.pressure)[0];
    out.node_pressure.assign(p, p + grid.node_count());
    out.node_saturation.assign(grid.node_count(), std::numeric_limits<double>::quiet_NaN());
    out.cell_pressure = cell_values(grid, p);
    for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
      const auto& law = saturation[static_cast<std::size_t>(grid.region(cell))];
      for (int i = 0; i < cell_nodes<dim>; ++i) {
        const int node = grid.cell_nodes_of(cell)[i];
        out.node_saturation[static_cast<std::size_t>(node)] = law(p[node]);
      }
      out.cell_saturation.push_back(law(out.cell_pressure[cell]));
    }
    const auto copy = [](const Column& column) {
      return std::vector<double>(column.values().begin(), column.values().end());
    };
    out.points.pressure = copy(*columns_.point_pressure);
    out.points.saturation = copy(*columns_.point_saturation);
  });
}

template <int dim>
void Seepage<dim>::join(StagePlan<dim>& plan) {
  provide_columns(plan);
  double scale = std::numeric_limits<double>::infinity();
  for (const Soil& soil : plan.problem.soils)
    with_soil_water(soil, *plan.problem.water,
                    [&scale](const auto& laws) { scale = std::min(scale, laws.curve.pressure_scale()); });
  add_terms(plan);
  step_ = std::make_unique<SeepageStep<dim>>(plan, *water_, columns_, scale);
  plan.add(Phase::pressure, "Newton's method and step control", [this] { step_->run(); });
  plan.at_ready([this, &plan] { prepare(plan); });
  add_ledger(plan);
  add_point_update(plan);
  add_output(plan);
  plan.at_entry([this, &plan] { (*columns_.steps)[step_proposal][0] = plan.stage.end_time - plan.begin_time(); });
  // Measured (README section 7): steps grow with tolerance^{-1/3} (BDF2) from 170 at 1e-4; per step and point 1.5 us,
  // and per solve 4e-8 s nodes^1.5 for the sparse direct solver, four solves a step.
  const double order = plan.stage.integrator == TimeIntegrator::bdf2 ? 3 : 2;
  plan.expect_steps(170 * std::pow(1e-4 / plan.stage.time_tolerance, 1 / order));
  plan.expect_cost(1.5e-6 * static_cast<double>(plan.fields.points.size()) +
                   1.6e-7 * std::pow(static_cast<double>(plan.fields.grid.node_count()), 1.5));
  plan.add_accuracy_limit("accuracy", "local error of p <= time_tolerance (extrapolation against BDF2)",
                          [this] { return step_->proposal(); });
  plan.at_record([this](double, meshes::FieldHistory& history) {
    history.counters["Newton iterations"] += static_cast<double>(std::exchange(step_->newton_iterations, 0));
    history.counters["rejected steps"] += static_cast<double>(std::exchange(step_->rejected_steps, 0));
    history.counters["failed Newton solves"] += static_cast<double>(std::exchange(step_->failed_solves, 0));
  });
}

template class Seepage<2>;
template class Seepage<3>;

}  // namespace wetfront::mpm
