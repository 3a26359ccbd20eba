#include "mpm/laws/soil_water.h"
#include "mpm/skeleton/rigid_skeleton.h"
#include "mpm/two_velocity/nodal_vector.h"
#include "mpm/two_velocity/two_velocity.h"

/// Steps I to III of the two-velocity scheme: momentum of the liquid, and what it does to a moving skeleton.
namespace wetfront::mpm {

/// Step I: water and velocity of the points to the nodes.
template <int dim>
void TwoVelocityLiquid<dim>::add_gather(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  auto& points = plan.fields.points;
  const Column& shape = plan.require_on_points("shape value");
  const std::size_t nodes = plan.fields.grid.node_count();
  // (nS)_i from the water of the points; it changes only with step VI (and with points that move).
  content_ = [this, &w, &points, &shape, nodes] {
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
      const Vector<dim> momentum = at<dim>(*w.velocity, i), solid = w.skeleton->velocity(i);
      Vector<dim> v{};
      for (int a = 0; a < dim; ++a) v[a] = momentum[a] / ((*w.content)[0][i] * (*w.volume)[0][i]) - solid[a];
      w.walls.project(i, v);
      for (int a = 0; a < dim; ++a) v[a] += solid[a];
      put<dim>(*w.velocity, i, v);
    }
  };
  if (moving_ != nullptr)
    plan.add(Phase::gather, "skeleton velocity", [skeleton = moving_] { skeleton->read_momentum(); });
  plan.add(Phase::gather, "liquid velocity of points to nodes", from_points_);
  plan.at_ready(content_);
}

/// Steps II and III: forces and drag at the nodes, points from accelerations, velocities mapped back (MUSL).
template <int dim>
void TwoVelocityLiquid<dim>::add_momentum(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  auto& points = plan.fields.points;
  const Column& shape = plan.require_on_points("shape value");
  const std::size_t nodes = plan.fields.grid.node_count();
  if (moving_ != nullptr) add_pull_on_skeleton(plan);
  const Vector<dim> weight = liquid_weight(plan);
  forces_ = [&w, &plan, &points, weight, nodes] {
    for (int a = 0; a < dim; ++a)
      for (std::size_t i = 0; i < nodes; ++i) (*w.force)[a][i] = weight[a] * (*w.volume)[0][i];
    for (const Block& block : points.blocks())
      for (int i = 0; i < cell_nodes<dim>; ++i)
        for (int a = 0; a < dim; ++a)
          (*w.force)[a][block.nodes[i]] +=
              w.cells.pressure[block.cell] * w.cells.gradient[block.cell][i][a] + w.cells.hanging[block.cell][i][a];
    if (w.surface) w.surface->push(w, plan.clock.time);
  };
  plan.add(Phase::accelerate, "liquid forces", forces_);
  const bool as_paper = plan.stage.liquid == LiquidScheme::explicit_drag;
  plan.add(Phase::accelerate, as_paper ? ExplicitDrag::name : ImplicitDrag::name, [&w, &plan, nodes] {
    for (std::size_t i = 0; i < nodes; ++i) {
      if (!((*w.volume)[0][i] > 0)) continue;
      Velocities<dim> v = w.skeleton->driven(w, i, (*w.mobility)[0][i], plan.clock.dt);
      w.keep_to_walls(i, v);
      put<dim>(*w.velocity_new, i, v.liquid);
      w.skeleton->set_new(i, v.solid, plan.clock.dt);
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
  if (moving_ != nullptr)
    plan.add(Phase::point_velocity, "skeleton velocity mapped back",
             [skeleton = moving_] { skeleton->read_velocity(); });
  plan.add(Phase::point_velocity, "liquid velocity mapped back", from_points_);
}

/// Of the force on both phases together, F = - sum_p V_p sigma grad N + (m_s + m_l) g with sigma = sigma' - S p I
/// (Eq. 2, steps II), the part that the skeleton alone does not know: + sum_c S_c p_c grad_ci + m_l g. It joins the
/// skeleton's force at the end of step I, before that is damped.
template <int dim>
void TwoVelocityLiquid<dim>::add_pull_on_skeleton(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  Column& force = moving_->force();
  for (std::size_t r = 0; r < plan.problem.soils.size(); ++r) {
    const Soil& soil = plan.problem.soils[r];
    with_soil_water(soil, *plan.problem.water, [&](const auto& laws) {
      const auto pull = [&w, &force, laws](const Block& block) {
        const double p = w.cells.pressure[block.cell], saturation = laws.saturation(p);
        for (int i = 0; i < cell_nodes<dim>; ++i)
          for (int a = 0; a < dim; ++a)
            force[a][block.nodes[i]] +=
                saturation * (p * w.cells.gradient[block.cell][i][a] + w.cells.hanging[block.cell][i][a]);
      };
      plan.add_over_blocks(Phase::gather, "pore pressure on skeleton [" + soil.name + "]", static_cast<int>(r), pull);
    });
  }
  plan.add(Phase::gather, "weight of pore liquid", [&w, &force, weight = liquid_weight(plan)] {
    for (int a = 0; a < dim; ++a)
      for (std::size_t i = 0; i < force.size(); ++i) force[a][i] += weight[a] * (*w.content)[0][i] * (*w.volume)[0][i];
  });
}

template void TwoVelocityLiquid<2>::add_gather(StagePlan<2>&);
template void TwoVelocityLiquid<3>::add_gather(StagePlan<3>&);
template void TwoVelocityLiquid<2>::add_momentum(StagePlan<2>&);
template void TwoVelocityLiquid<3>::add_momentum(StagePlan<3>&);
template void TwoVelocityLiquid<2>::add_pull_on_skeleton(StagePlan<2>&);
template void TwoVelocityLiquid<3>::add_pull_on_skeleton(StagePlan<3>&);

}  // namespace wetfront::mpm
