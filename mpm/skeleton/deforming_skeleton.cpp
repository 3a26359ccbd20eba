#include "mpm/skeleton/deforming_skeleton.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/skeleton/spline_shape.h"

#include <cmath>
#include <limits>
#include <map>
#include <set>

/// How the skeleton joins a plan: columns, laws, kernels, limits. What the kernels do: skeleton_step.cpp.
namespace wetfront::mpm {

template <int dim>
DeformingSkeleton<dim>::DeformingSkeleton(Origin origin)
    : Effect<dim>("deforming skeleton", std::move(origin),
                  "Lee 2021 Eqs 2, 11 to 17 and 19, corrected (mpm/skeleton/README.md)"),
      cycle_(std::make_shared<SkeletonCycle<dim>>()) {}

template <int dim>
void DeformingSkeleton<dim>::provide_columns(StagePlan<dim>& plan) {
  const std::string mass = dim == 2 ? "kg/m" : "kg";
  const std::string force = dim == 2 ? "N/m" : "N";
  c_.position = &plan.require_on_points("position");
  c_.volume = &plan.require_on_points("volume");
  const bool fresh = plan.fields.points.columns.find_allocated("mass") == nullptr;
  c_.mass = &plan.provide_on_points({"mass", "m_s", mass});
  c_.velocity = &plan.provide_on_points({"velocity", "v_s", "m/s", dim});
  c_.stress = &plan.provide_on_points({"stress", "sigma'", "Pa", stress_components<dim>});
  c_.node_mass = &plan.provide_on_nodes({"mass", "m_i", mass, 1, Lifetime::step});
  c_.node_force = &plan.provide_on_nodes({"force", "f_i", force, dim, Lifetime::step});
  c_.node_velocity = &plan.provide_on_nodes({"velocity", "v_i", "m/s", dim, Lifetime::step});
  c_.node_acceleration = &plan.provide_on_nodes({"acceleration", "a_i", "m/s2", dim, Lifetime::step});
  c_.node_displacement = &plan.provide_on_nodes({"displacement", "u_i", "m", dim});
  rates_ = &plan.provide_on_run(
      {"skeleton rates", "(c/h)^2, (v/h)^2", "1/s2", 2 * static_cast<int>(plan.problem.soils.size())});
  provide_variants(plan);
  if (fresh) plan.at_entry([this, &plan] { begin_points(plan); });
  // A stage in true time has weighed its points with their water (coupling/true_time.h).
  if (const Column* grains = plan.fields.points.columns.find_allocated("grain mass"))
    plan.at_entry([this, grains] { std::ranges::copy(grains->values(), c_.mass->values().begin()); });
}

/// Columns that only some schemes and problems call for.
template <int dim>
void DeformingSkeleton<dim>::provide_variants(StagePlan<dim>& plan) {
  const SkeletonScheme& scheme = plan.problem.skeleton;
  if (scheme.transfer == Transfer::apic)
    c_.affine = &plan.provide_on_points({"affine velocity", "C", "1/s", dim * dim});
  if (scheme.transfer == Transfer::apic || scheme.pic > 0)
    c_.node_new_velocity = &plan.provide_on_nodes({"new velocity", "v_i + dt a_i", "m/s", dim, Lifetime::step});
  if (plan.problem.body_acceleration) {
    c_.initial_position = &plan.provide_on_points({"initial position", "X", "m", dim});
    body_ = &plan.provide_on_points({"body acceleration", "b", "m/s2", dim, Lifetime::step});
  }
}

template <int dim>
void DeformingSkeleton<dim>::begin_points(StagePlan<dim>& plan) {
  const auto& points = plan.fields.points;
  for (const Block& block : points.blocks()) {
    const Soil& soil = plan.problem.soils[static_cast<std::size_t>(block.soil)];
    for (std::size_t p = block.first; p < block.first + block.count; ++p) {
      (*c_.mass)[0][p] = (1 - soil.porosity) * soil.grain_density * (*c_.volume)[0][p];
      const Vector<dim> x = points.position(p);
      const Vector<dim> v = plan.problem.initial_velocity ? plan.problem.initial_velocity(x) : Vector<dim>{};
      for (int a = 0; a < dim; ++a) {
        (*c_.velocity)[a][p] = v[a];
        if (c_.initial_position != nullptr) (*c_.initial_position)[a][p] = x[a];
      }
    }
  }
  if (c_.affine != nullptr && plan.problem.initial_velocity) begin_affine(plan);
  for (std::size_t r = 0; r < soils_.size(); ++r) soils_[r]->begin(points.blocks(static_cast<int>(r)));
}

/// The gradient of the given velocity: without it a body that turns would begin with the spin of its points' centres
/// only. Central differences over a thousandth of a cell, exact for linear velocities to 1e-12.
template <int dim>
void DeformingSkeleton<dim>::begin_affine(StagePlan<dim>& plan) {
  const auto& points = plan.fields.points;
  for (const Block& block : points.blocks()) {
    const double arm = 1e-3 * plan.fields.grid.smallest_altitude(block.cell);
    for (std::size_t p = block.first; p < block.first + block.count; ++p)
      for (int b = 0; b < dim; ++b) {
        Vector<dim> before = points.position(p), after = before;
        before[b] -= arm, after[b] += arm;
        const Vector<dim> low = plan.problem.initial_velocity(before), high = plan.problem.initial_velocity(after);
        for (int a = 0; a < dim; ++a) (*c_.affine)[a * dim + b][p] = (high[a] - low[a]) / (2 * arm);
      }
  }
}

template <int dim>
void DeformingSkeleton<dim>::find_fixed(StagePlan<dim>& plan) {
  for (auto& axis : cycle_->fixed) axis.assign(plan.fields.grid.columns.size(), 0);
  const auto fix = [this](const Fixity& fixity, int node) {
    for (std::size_t a = 0; a < dim; ++a) {
      char& held = cycle_->fixed[a][static_cast<std::size_t>(node)];
      if (fixity.fixed[a] && !held) fixed_[a].push_back(node);
      held = held || fixity.fixed[a];
    }
  };
  for (const Fixity& fixity : plan.problem.fixities) {
    // The whole side, also where no soil is yet: a body runs out onto its base.
    const meshes::Side& side = named_side(plan.problem.mesh, fixity.side, "a fixity", fixity.origin);
    if (splines_)
      for (const auto& node : splines_->side(plan.problem.mesh, fixity.side)) fix(fixity, node.index);
    else
      for (const int node : side.faces) fix(fixity, node);
  }
}

namespace {

/// Nodes of the mesh on sides that nothing holds.
template <int dim>
std::vector<int> open_nodes(const Problem<dim>& problem) {
  std::set<std::string> held;
  for (const Fixity& fixity : problem.fixities) held.insert(fixity.side);
  for (const SkeletonBoundary& boundary : problem.skeleton_boundary)
    std::visit(
        [&held]<class Condition>(const Condition& condition) {
          if constexpr (!std::is_same_v<Condition, Traction>) held.insert(condition.side);
          if constexpr (std::is_same_v<Condition, PeriodicSkeleton>) held.insert(condition.partner);
        },
        boundary);
  std::vector<int> open;
  for (const meshes::Side& side : problem.mesh.sides)
    if (!held.contains(side.name)) open.insert(open.end(), side.faces.begin(), side.faces.end());
  return open;
}

}  // namespace

template <int dim>
void DeformingSkeleton<dim>::choose_laws(StagePlan<dim>& plan) {
  const auto& grid = plan.fields.grid;
  std::map<std::string, Column*> provided;
  const auto memory = [&](const std::vector<ColumnSpec>& specs) {
    std::vector<MemoryColumn> columns;
    for (const ColumnSpec& spec : specs) {
      auto& column = provided[spec.name];
      if (column == nullptr) column = &plan.provide_on_points(spec);
      for (int c = 0; c < spec.components; ++c) columns.push_back({column, c});
    }
    return columns;
  };
  const SoilMotionSetting<dim> setting{c_, grid.smallest_altitudes(), memory};
  for (const Soil& soil : plan.problem.soils) {
    if (strengthened_by_suction(soil)) c_.suction = &plan.require_on_points("suction");
    if (splines_)
      soils_.push_back(make_soil_motion<dim>(soil, SplineShape<dim>(*splines_), setting));
    else
      soils_.push_back(make_soil_motion<dim>(soil, LinearShape<dim>(grid), setting));
  }
}

namespace {

/// Its cycle is the step of the plan; otherwise mpm/coupling/ runs it as often as it takes.
bool rules_the_steps(const Stage& stage) {
  return stage.motion == SkeletonMotion::dynamic && stage.liquid != LiquidScheme::seepage &&
         stage.liquid != LiquidScheme::semi_implicit;
}

}  // namespace

template <int dim>
void DeformingSkeleton<dim>::add_kernels(StagePlan<dim>& plan) {
  const bool dynamic = rules_the_steps(plan.stage);
  const bool first = plan.problem.skeleton.update == StressUpdate::usf;
  const auto add = [&](Phase phase, const char* name, std::function<void()> body) {
    return &(dynamic ? plan.add(phase, name, std::move(body)) : plan.add_iterated(phase, name, std::move(body)));
  };
  cycle_->damping = plan.stage.local_damping;
  cycle_->gather =
      add(Phase::gather, first ? "masses, momenta, stress, internal forces" : "masses, momenta, internal forces",
          [this, &plan, dynamic] {
            if (dynamic) cycle_->dt = plan.clock.dt;
            gather();
          });
  cycle_->accelerate = add(Phase::accelerate, "accelerations", [this] { accelerate(); });
  cycle_->points = add(Phase::point_velocity,
                       plan.problem.skeleton.update == StressUpdate::musl ? "points, and momentum back" : "points",
                       [this] { points(); });
  cycle_->velocity = add(Phase::point_velocity, "nodal velocity", [this] { velocity(); });
  cycle_->move = add(Phase::move, first ? "positions" : "deformation, stress, volumes, positions",
                     [this, first] { move(!first, true); });
  cycle_->migrate = add(Phase::carry, "migration", [this] { migration_->run(); });
}

template <int dim>
void DeformingSkeleton<dim>::add_limits(StagePlan<dim>& plan) {
  const auto wave = [this](std::size_t soil) {
    return 1 / std::sqrt(static_cast<double>(dim) * (*rates_)[2 * static_cast<int>(soil)][0]);
  };
  const auto motion = [this, soils = soils_.size()] {
    double rate = 0;
    for (std::size_t r = 0; r < soils; ++r) rate = std::max(rate, (*rates_)[2 * static_cast<int>(r) + 1][0]);
    return 1 / std::sqrt(rate);
  };
  cycle_->crossing = motion;
  cycle_->stable_step = [wave, motion, soils = soils_.size()] {
    double step = motion();
    for (std::size_t r = 0; r < soils; ++r) step = std::min(step, wave(r));
    return step;
  };
  if (!rules_the_steps(plan.stage)) return;
  for (std::size_t r = 0; r < soils_.size(); ++r)
    plan.add_stability_limit("compression wave [" + plan.problem.soils[r].name + "]",
                             "h/(sqrt(dim) c), c^2 = E_oed V/m_s, the least over the points",
                             [wave, r] { return wave(r); });
  plan.add_stability_limit("motion of points", "h/|v|, the least over the points", motion);
}

template <int dim>
void DeformingSkeleton<dim>::tell(StagePlan<dim>& plan) {
  plan.at_output([this, &plan](meshes::Snapshot& out) {
    out.node_displacement.resize(plan.fields.grid.node_count());
    for (std::size_t i = 0; i < out.node_displacement.size(); ++i)
      for (int a = 0; a < dim; ++a)
        out.node_displacement[i][static_cast<std::size_t>(a)] =
            splines_ ? splines_->at_mesh_node(i, (*c_.node_displacement)[a]) : (*c_.node_displacement)[a][i];
  });
}

template <int dim>
void DeformingSkeleton<dim>::join(StagePlan<dim>& plan) {
  plan_ = &plan;
  if (plan.problem.skeleton.shape == ShapeFunctions::quadratic_spline)
    splines_ = std::make_unique<SplineGrid<dim>>(plan.problem.mesh);
  provide_columns(plan);
  find_fixed(plan);
  choose_laws(plan);
  migration_ = std::make_unique<Migration<dim>>(plan);
  const Column* gravity = plan.fields.run.find("gravity");
  if (gravity != nullptr && !gravity->provided_by().empty()) gravity_ = gravity;
  const auto& grid = plan.fields.grid;
  chunks_ = std::make_unique<Chunks<dim>>(grid.cell_count(), grid.columns.size(), [this, &grid](std::size_t cell) {
    std::vector<int> nodes(grid.cell_nodes_of(cell), grid.cell_nodes_of(cell) + cell_nodes<dim>);
    if (!splines_) return nodes;
    nodes.resize(SplineGrid<dim>::nodes);
    splines_->nodes_of(cell, nodes.data());
    return nodes;
  });
  if (plan.problem.skeleton.integration_of(plan.stage.liquid.has_value()) == StressIntegration::mixed)
    covered_ = std::make_unique<CoveredCells<dim>>(grid, open_nodes(plan.problem));
  team_ = std::make_unique<Team>(plan.problem.threads);
  active_ = std::make_unique<ActiveNodes>(grid.columns.size());
  cycle_->active = active_.get();
  migration_->prepare(chunks_->size());
  found_.resize(chunks_->size() * soils_.size());
  add_kernels(plan);
  add_limits(plan);
  plan.at_begin([this] { find_rates(); });
  tell(plan);
  plan.expect_cost(50e-9 * static_cast<double>(plan.fields.points.size()));  // measured, README.md
}

template class DeformingSkeleton<2>;
template class DeformingSkeleton<3>;

}  // namespace wetfront::mpm
