#include "mpm/skeleton/elastic_skeleton.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/laws/linear_elastic.h"
#include "mpm/skeleton/rigid_skeleton.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::mpm {

template <int dim>
void ElasticSkeleton<dim>::provide_columns(StagePlan<dim>& plan) {
  const std::string mass = dim == 2 ? "kg/m" : "kg";
  const std::string force = dim == 2 ? "N/m" : "N";
  c_.position = &plan.require_on_points("position");
  c_.volume = &plan.require_on_points("volume");
  const Column* earlier_mass = plan.fields.points.columns.find("mass");
  const bool fresh = earlier_mass == nullptr || !earlier_mass->allocated();
  c_.mass = &plan.provide_on_points({"mass", "m_s", mass});
  c_.velocity = &plan.provide_on_points({"velocity", "v_s", "m/s", dim});
  c_.stress = &plan.provide_on_points({"stress", "sigma'", "Pa", stress_components<dim>});
  c_.shape = &plan.provide_on_points(shape_value_spec<dim>());
  c_.gradient = &plan.provide_on_points(shape_gradient_spec<dim>());
  c_.increment = &plan.provide_on_points({"velocity gradient", "grad v dt", "-", dim * dim, Lifetime::step});
  c_.node_mass = &plan.provide_on_nodes({"mass", "m_i", mass, 1, Lifetime::step});
  c_.node_force = &plan.provide_on_nodes({"force", "f_i", force, dim, Lifetime::step});
  c_.node_velocity = &plan.provide_on_nodes({"velocity", "v_i", "m/s", dim, Lifetime::step});
  c_.node_acceleration = &plan.provide_on_nodes({"acceleration", "a_i", "m/s2", dim, Lifetime::step});
  c_.node_displacement = &plan.provide_on_nodes({"displacement", "u_i", "m", dim});
  if (fresh)
    plan.at_entry([this, &plan] {
      for (const Block& block : plan.fields.points.blocks()) {
        const Soil& soil = plan.problem.soils[static_cast<std::size_t>(plan.fields.grid.region(block.cell))];
        for (std::size_t p = block.first; p < block.first + block.count; ++p)
          (*c_.mass)[0][p] = (1 - soil.porosity) * soil.grain_density * (*c_.volume)[0][p];
      }
    });
}

/// I: stencils at the present positions, nodal mass and momentum.
template <int dim>
void ElasticSkeleton<dim>::add_gather(StagePlan<dim>& plan) {
  plan.add_over_blocks(Phase::gather, "stencils", [this, &fields = plan.fields](const Block& block) {
    fill_stencils<dim>(fields.grid, fields.points, block, *c_.shape, *c_.gradient);
  });
  plan.add(Phase::gather, "clear nodes", [this] {
    for (Column* column : {c_.node_mass, c_.node_force, c_.node_velocity, c_.node_acceleration}) column->fill(0);
  });
  plan.add_over_blocks(Phase::gather, "mass and momentum", [this](const Block& block) {
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      double mass = 0;
      Vector<dim> momentum{};
      for (std::size_t p = block.first; p < block.first + block.count; ++p) {
        const double share = (*c_.mass)[0][p] * (*c_.shape)[i][p];
        mass += share;
        for (int a = 0; a < dim; ++a) momentum[a] += share * (*c_.velocity)[a][p];
      }
      (*c_.node_mass)[0][block.nodes[i]] += mass;
      for (int a = 0; a < dim; ++a) (*c_.node_velocity)[a][block.nodes[i]] += momentum[a];
    }
  });
}

/// II: f_i = - sum_p V_p sigma_p grad N_i + m_i g, local damping, a_i = f_i / m_i, fixities.
template <int dim>
void ElasticSkeleton<dim>::add_accelerate(StagePlan<dim>& plan) {
  plan.add_over_blocks(Phase::accelerate, "internal force", [this](const Block& block) {
    // Place of component (a, b) in the stored tensor.
    static constexpr int at[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      Vector<dim> force{};
      for (std::size_t p = block.first; p < block.first + block.count; ++p)
        for (int a = 0; a < dim; ++a)
          for (int b = 0; b < dim; ++b)
            force[a] -= (*c_.volume)[0][p] * (*c_.stress)[at[a][b]][p] * (*c_.gradient)[i * dim + b][p];
      for (int a = 0; a < dim; ++a) (*c_.node_force)[a][block.nodes[i]] += force[a];
    }
  });
  const Column* gravity = plan.fields.run.find("gravity");
  if (gravity != nullptr && !gravity->provided_by().empty())
    plan.add(Phase::accelerate, "weight", [this, gravity] {
      for (int a = 0; a < dim; ++a)
        for (std::size_t i = 0; i < c_.node_mass->size(); ++i)
          (*c_.node_force)[a][i] += (*c_.node_mass)[0][i] * (*gravity)[a][0];
    });
  if (plan.stage.local_damping > 0)
    plan.add(Phase::accelerate, "local damping", [this, damping = plan.stage.local_damping] {
      for (int a = 0; a < dim; ++a)
        for (std::size_t i = 0; i < c_.node_mass->size(); ++i) {
          double& force = (*c_.node_force)[a][i];
          const double momentum = (*c_.node_velocity)[a][i];
          if (momentum != 0) force -= damping * std::copysign(std::abs(force), momentum);
        }
    });
  plan.add(Phase::accelerate, "accelerations", [this] {
    for (int a = 0; a < dim; ++a)
      for (std::size_t i = 0; i < c_.node_mass->size(); ++i) {
        const double mass = (*c_.node_mass)[0][i];
        (*c_.node_acceleration)[a][i] = mass > 0 ? (*c_.node_force)[a][i] / mass : 0.0;
      }
    fix(*c_.node_acceleration);
  });
}

/// III: points from accelerations (Eq. 13), nodal velocities from the new point momenta (Eq. 14).
template <int dim>
void ElasticSkeleton<dim>::add_point_velocity(StagePlan<dim>& plan) {
  plan.add(Phase::point_velocity, "clear nodal velocity", [this] { c_.node_velocity->fill(0); });
  plan.add_over_blocks(Phase::point_velocity, "points, and momentum back", [this, &plan](const Block& block) {
    const double dt = plan.clock.dt;
    for (int a = 0; a < dim; ++a) {
      std::array<double, cell_nodes<dim>> momentum{};
      for (std::size_t p = block.first; p < block.first + block.count; ++p) {
        double acceleration = 0;
        for (int i = 0; i < cell_nodes<dim>; ++i)
          acceleration += (*c_.shape)[i][p] * (*c_.node_acceleration)[a][block.nodes[i]];
        const double velocity = (*c_.velocity)[a][p] += dt * acceleration;
        for (int i = 0; i < cell_nodes<dim>; ++i) momentum[i] += (*c_.mass)[0][p] * (*c_.shape)[i][p] * velocity;
      }
      for (int i = 0; i < cell_nodes<dim>; ++i) (*c_.node_velocity)[a][block.nodes[i]] += momentum[i];
    }
  });
  plan.add(Phase::point_velocity, "nodal velocity", [this, &plan] {
    for (int a = 0; a < dim; ++a)
      for (std::size_t i = 0; i < c_.node_mass->size(); ++i) {
        const double mass = (*c_.node_mass)[0][i];
        (*c_.node_velocity)[a][i] = mass > 0 ? (*c_.node_velocity)[a][i] / mass : 0.0;
      }
    fix(*c_.node_velocity);
    for (int a = 0; a < dim; ++a)
      for (std::size_t i = 0; i < c_.node_mass->size(); ++i)
        (*c_.node_displacement)[a][i] += plan.clock.dt * (*c_.node_velocity)[a][i];
  });
}

/// IV and V: grad v dt (Eqs 15, 17) and the effective stress (Eq. 16, corrected).
template <int dim>
void ElasticSkeleton<dim>::add_stress(StagePlan<dim>& plan) {
  plan.add_over_blocks(Phase::strain, "velocity gradient", [this, &plan](const Block& block) {
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b)
        for (std::size_t p = block.first; p < block.first + block.count; ++p) {
          double sum = 0;
          for (int i = 0; i < cell_nodes<dim>; ++i)
            sum += (*c_.node_velocity)[a][block.nodes[i]] * (*c_.gradient)[i * dim + b][p];
          (*c_.increment)[a * dim + b][p] = plan.clock.dt * sum;
        }
  });
  for (std::size_t r = 0; r < plan.problem.soils.size(); ++r) {
    const Soil& soil = plan.problem.soils[r];
    const LinearElastic law(*soil.elastic);
    const auto update = [this, law](const Block& block) {
      for (std::size_t p = block.first; p < block.first + block.count; ++p) {
        StepGradient<dim> step;
        for (int a = 0; a < dim; ++a)
          for (int b = 0; b < dim; ++b) step.plane[a][b] = (*c_.increment)[a * dim + b][p];
        LawPoint<LinearElastic, dim> point;
        for (int k = 0; k < stress_components<dim>; ++k) point.stress[k] = (*c_.stress)[k][p];
        law.advance(point, step);
        for (int k = 0; k < stress_components<dim>; ++k) (*c_.stress)[k][p] = point.stress[k];
      }
    };
    plan.add_over_blocks(Phase::stress, "effective stress [" + soil.name + "]", static_cast<int>(r), update);
    const double speed = std::sqrt(law.constrained_modulus() / ((1 - soil.porosity) * soil.grain_density));
    double altitude = std::numeric_limits<double>::infinity();
    for (std::size_t cell = 0; cell < plan.fields.grid.cell_count(); ++cell)
      if (plan.fields.grid.region(cell) == static_cast<int>(r))
        altitude = std::min(altitude, plan.fields.grid.smallest_altitude(cell));
    const double limit = altitude / (std::sqrt(static_cast<double>(dim)) * speed);
    plan.add_stability_limit("compression wave [" + soil.name + "]", "h/(sqrt(dim) c), c^2 = E_oed/((1-n) rho_s)",
                             [limit] { return limit; });
  }
}

/// VIII and IX: volumes, positions (Eq. 19), cells.
template <int dim>
void ElasticSkeleton<dim>::add_move(StagePlan<dim>& plan) {
  plan.add_over_blocks(Phase::move, "volumes and positions", [this, &plan](const Block& block) {
    const double dt = plan.clock.dt;
    for (std::size_t p = block.first; p < block.first + block.count; ++p) {
      double dilation = 0;
      for (int a = 0; a < dim; ++a) {
        double velocity = 0;
        for (int i = 0; i < cell_nodes<dim>; ++i)
          velocity += (*c_.shape)[i][p] * (*c_.node_velocity)[a][block.nodes[i]];
        (*c_.position)[a][p] += dt * velocity;
        dilation += (*c_.increment)[a * dim + a][p];
      }
      (*c_.volume)[0][p] *= 1 + dilation;
    }
  });
  migration_ = std::make_unique<Migration<dim>>(plan);
  plan.add(Phase::carry, "migration", [this] { migration_->run(); });
  plan.at_output([this, &plan](meshes::Snapshot& out) {
    out.node_displacement.resize(plan.fields.grid.node_count());
    for (std::size_t i = 0; i < out.node_displacement.size(); ++i)
      for (int a = 0; a < dim; ++a)
        out.node_displacement[i][static_cast<std::size_t>(a)] = (*c_.node_displacement)[a][i];
  });
}

template <int dim>
void ElasticSkeleton<dim>::find_fixed(StagePlan<dim>& plan) {
  for (const Fixity& fixity : plan.problem.fixities)
    for (const auto& node : boundary_side(plan, fixity.side, "a fixity", fixity.origin).nodes)
      for (std::size_t a = 0; a < dim; ++a)
        if (fixity.fixed[a]) fixed_[a].push_back(node.index);
}

template <int dim>
void ElasticSkeleton<dim>::fix(Column& vector) const {
  for (int a = 0; a < dim; ++a)
    for (int node : fixed_[static_cast<std::size_t>(a)]) vector[a][node] = 0;
}

template <int dim>
void ElasticSkeleton<dim>::join(StagePlan<dim>& plan) {
  provide_columns(plan);
  find_fixed(plan);
  add_gather(plan);
  add_accelerate(plan);
  add_point_velocity(plan);
  add_stress(plan);
  add_move(plan);
  plan.expect_cost(150e-9 * static_cast<double>(plan.fields.points.size()));  // measured, README section 7
}

template class ElasticSkeleton<2>;
template class ElasticSkeleton<3>;

}  // namespace wetfront::mpm
