#include "mpm/grid/column_vector.h"
#include "mpm/two_velocity/two_velocity.h"

/// Steps I to III of the two-velocity scheme in a resting skeleton: momentum of the liquid.
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
  plan.add(Phase::point_velocity, "liquid velocity mapped back", from_points_);
}

template void TwoVelocityLiquid<2>::add_gather(StagePlan<2>&);
template void TwoVelocityLiquid<3>::add_gather(StagePlan<3>&);
template void TwoVelocityLiquid<2>::add_momentum(StagePlan<2>&);
template void TwoVelocityLiquid<3>::add_momentum(StagePlan<3>&);

}  // namespace wetfront::mpm
