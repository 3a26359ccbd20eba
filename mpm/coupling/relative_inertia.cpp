#include "mpm/coupling/relative_inertia.h"

#include "mpm/grid/column_vector.h"

#include <algorithm>

namespace wetfront::mpm {

namespace {

/// Of dt dv, what the skeleton moves by for a reaction that it learns of at the end of the step (README.md section 8b).
constexpr double owed_share = 1.5;

}  // namespace

template <int dim>
RelativeInertia<dim>::RelativeInertia(StagePlan<dim>& plan, const SeepageColumns& columns,
                                      const SkeletonCycle<dim>& cycle)
    : fresh_(plan.fields.points.columns.find_allocated(columns.flux->spec().name) == nullptr),
      plan_(plan),
      c_(columns),
      cycle_(cycle),
      volume_(&plan.require_on_points("volume")),
      mass_(&plan.require_on_points("mass")),
      water_(&plan.require_on_points("water")),
      shape_(&plan.require_on_points("shape value")),
      velocity_(&plan.require_on_points("velocity")),
      brought_(&plan.require_on_run("brought by water")),
      node_velocity_(&plan.require_on_nodes("velocity")),
      displacement_(&plan.require_on_nodes("displacement")),
      owed_(&plan.provide_on_nodes({"displacement owed", "du", "m", dim})) {}

template <int dim>
bool RelativeInertia<dim>::owes() const {
  return std::ranges::any_of(owed_->values(), [](double d) { return d != 0; });
}

template <int dim>
void RelativeInertia<dim>::begin(NodalWater<dim>& water) {
  constexpr double long_enough = 1e12;  // s: inertia is nothing beside drag
  if (!fresh_) return;
  c_.yielding->fill(1);
  water.dt = long_enough;
  for (Kernel* remember : water.accepted) remember->run();
}

template <int dim>
void RelativeInertia<dim>::before_motion() {
  for (const Block& block : plan_.fields.points.blocks())
    for (int a = 0; a < dim; ++a)
      for (std::size_t q = block.first; q < block.first + block.count; ++q) {
        (*c_.acceleration)[a][q] = (*velocity_)[a][q];
        (*c_.flux)[a][q] *= (*volume_)[0][q];
      }
}

template <int dim>
void RelativeInertia<dim>::after_motion(double dt) {
  const double density = plan_.problem.water->density;
  for (const Block& block : plan_.fields.points.blocks())
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      for (int a = 0; a < dim; ++a) {
        (*c_.acceleration)[a][q] = ((*velocity_)[a][q] - (*c_.acceleration)[a][q]) / dt;
        (*c_.flux)[a][q] /= (*volume_)[0][q];
      }
      const double water = (*water_)[0][q], part = density * water / (*mass_)[0][q];
      (*c_.yielding)[0][q] = water / (*volume_)[0][q] / (1 - part);
    }
  flux_before_.assign(c_.flux->values().begin(), c_.flux->values().end());
}

/// dv of the nodes.
template <int dim>
void RelativeInertia<dim>::find_change() {
  const std::size_t nodes = node_velocity_->size(), slots = c_.flux->size();
  const double density = plan_.problem.water->density;
  change_.assign(nodes * dim, 0.0);
  node_mass_.assign(nodes, 0.0);
  for (const Block& block : plan_.fields.points.blocks())
    for (std::size_t q = block.first; q < block.first + block.count; ++q)
      for (int i = 0; i < cell_nodes<dim>; ++i) {
        const auto node = static_cast<std::size_t>(block.nodes[i]);
        const double n = (*shape_)[i][q], water = density * (*volume_)[0][q];
        node_mass_[node] += n * (*mass_)[0][q];
        for (int a = 0; a < dim; ++a)
          change_[static_cast<std::size_t>(a) * nodes + node] -=
              n * water * ((*c_.flux)[a][q] - flux_before_[static_cast<std::size_t>(a) * slots + q]);
      }
  for (int a = 0; a < dim; ++a)
    for (std::size_t i = 0; i < nodes; ++i) {
      double& change = change_[static_cast<std::size_t>(a) * nodes + i];
      change = node_mass_[i] > 0 && cycle_.fixed[static_cast<std::size_t>(a)][i] == 0 ? change / node_mass_[i] : 0.0;
    }
}

template <int dim>
void RelativeInertia<dim>::react(double dt) {
  find_change();
  const std::size_t nodes = node_velocity_->size();
  for (const Block& block : plan_.fields.points.blocks())
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      const Vector<dim> before = at<dim>(*velocity_, q);
      Vector<dim> gained{};
      for (int i = 0; i < cell_nodes<dim>; ++i)
        for (int a = 0; a < dim; ++a)
          gained[a] +=
              (*shape_)[i][q] * change_[static_cast<std::size_t>(a) * nodes + static_cast<std::size_t>(block.nodes[i])];
      const double mass = (*mass_)[0][q];
      (*brought_)[0][0] += mass * (dot<dim>(before, gained) + 0.5 * dot<dim>(gained, gained));
      for (int a = 0; a < dim; ++a) {
        (*brought_)[1 + a][0] += mass * gained[a];
        (*velocity_)[a][q] += gained[a];
      }
    }
  for (int a = 0; a < dim; ++a)
    for (std::size_t i = 0; i < nodes; ++i)
      (*owed_)[a][i] = owed_share * dt * change_[static_cast<std::size_t>(a) * nodes + i];
}

template <int dim>
void RelativeInertia<dim>::pay(double dt) {
  for (int a = 0; a < dim; ++a)
    for (std::size_t i = 0; i < owed_->size(); ++i) {
      (*node_velocity_)[a][i] = (*owed_)[a][i] / dt;
      (*displacement_)[a][i] += (*owed_)[a][i];
    }
  owed_->fill(0);
}

template class RelativeInertia<2>;
template class RelativeInertia<3>;

}  // namespace wetfront::mpm
