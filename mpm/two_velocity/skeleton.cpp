#include "mpm/two_velocity/skeleton.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/two_velocity/water.h"

namespace wetfront::mpm {

template <int dim, class Drag>
Velocities<dim> RestingSkeleton<dim, Drag>::driven(const TwoVelocityWater<dim>& water, std::size_t i, double mobility,
                                                   double dt) const {
  NodalDrag node;
  node.drag = dt * (*water.content)[0][i] / (mobility * water.density);
  const double per_force = dt / (water.density * (*water.volume)[0][i]);
  Velocities<dim> v;
  for (int a = 0; a < dim; ++a) {
    node.before = (*water.velocity)[a][i];
    node.pushed = node.before + per_force * (*water.force)[a][i];
    v.liquid[a] = Drag::liquid(node);
  }
  return v;
}

template <int dim>
MovingSkeleton<dim>::MovingSkeleton(StagePlan<dim>& plan)
    : velocity_(plan.provide_on_nodes({"skeleton velocity", "v_s", "m/s", dim, Lifetime::step})),
      mass_(plan.require_on_nodes("mass")),
      force_(plan.require_on_nodes("force")),
      momentum_(plan.require_on_nodes("velocity")),
      acceleration_(plan.require_on_nodes("acceleration")) {
  for (auto& axis : fixed_) axis.assign(plan.fields.grid.node_count(), 0);
  for (const Fixity& fixity : plan.problem.fixities)
    for (const auto& node : boundary_side(plan, fixity.side, "a fixity", fixity.origin).nodes)
      for (std::size_t a = 0; a < dim; ++a)
        if (fixity.fixed[a]) fixed_[a][static_cast<std::size_t>(node.index)] = 1;
}

template <int dim>
void MovingSkeleton<dim>::read_momentum() {
  for (int a = 0; a < dim; ++a)
    for (std::size_t i = 0; i < mass_.size(); ++i)
      velocity_[a][i] = fixed(a, i) || !(mass_[0][i] > 0) ? 0.0 : momentum_[a][i] / mass_[0][i];
}

template <int dim>
void MovingSkeleton<dim>::read_velocity() {
  for (int a = 0; a < dim; ++a)
    for (std::size_t i = 0; i < mass_.size(); ++i) velocity_[a][i] = momentum_[a][i];
}

template <int dim>
Vector<dim> MovingSkeleton<dim>::velocity(std::size_t i) const {
  Vector<dim> v{};
  for (int a = 0; a < dim; ++a) v[a] = velocity_[a][i];
  return v;
}

/// Two equations per axis (d = dt r, m = m_l/m_s, F the force on both phases together), drag as `Drag` says:
///   v_l' = v_l + dt F_l/(rho_l V) - d (v_l - v_s),   v_s' + m v_l' = v_s + m v_l + dt F/m_s.
template <int dim, class Drag>
Velocities<dim> DraggedSkeleton<dim, Drag>::driven(const TwoVelocityWater<dim>& water, std::size_t i, double mobility,
                                                   double dt) const {
  const double content = (*water.content)[0][i], volume = (*water.volume)[0][i], mass = this->mass_[0][i];
  const double drag = dt * content / (mobility * water.density), ratio = water.density * volume * content / mass;
  Velocities<dim> v;
  for (int a = 0; a < dim; ++a) {
    const bool held = this->fixed(a, i);
    NodalDrag node;
    node.before = (*water.velocity)[a][i];
    node.solid_before = this->velocity_[a][i];
    node.pushed = node.before + dt * (*water.force)[a][i] / (water.density * volume);
    node.both = held ? 0 : node.solid_before + ratio * node.before + dt * this->force_[a][i] / mass;
    node.ratio = held ? 0 : ratio;
    node.drag = drag;
    v.liquid[a] = Drag::liquid(node);
    v.solid[a] = held ? 0 : node.both - ratio * v.liquid[a];
  }
  return v;
}

template <int dim>
void MovingSkeleton<dim>::change_relative(const TwoVelocityWater<dim>& water, std::size_t i, const Vector<dim>& change,
                                          Velocities<dim>& v) const {
  const double liquid_mass = water.density * (*water.volume)[0][i] * (*water.content)[0][i];
  const double share = mass_[0][i] / (liquid_mass + mass_[0][i]);
  for (int a = 0; a < dim; ++a) {
    v.liquid[a] += (fixed(a, i) ? 1.0 : share) * change[a];
    v.solid[a] -= fixed(a, i) ? 0.0 : (1 - share) * change[a];
  }
}

template <int dim>
void MovingSkeleton<dim>::set_new(std::size_t i, const Vector<dim>& solid, double dt) {
  for (int a = 0; a < dim; ++a) acceleration_[a][i] = (solid[a] - velocity_[a][i]) / dt;
}

template <int dim>
Vector<dim> MovingSkeleton<dim>::get_new(std::size_t i, double dt) const {
  Vector<dim> v{};
  for (int a = 0; a < dim; ++a) v[a] = velocity_[a][i] + dt * acceleration_[a][i];
  return v;
}

template class RestingSkeleton<2, ImplicitDrag>;
template class RestingSkeleton<3, ImplicitDrag>;
template class RestingSkeleton<2, ExplicitDrag>;
template class RestingSkeleton<3, ExplicitDrag>;
template class DraggedSkeleton<2, ImplicitDrag>;
template class DraggedSkeleton<3, ImplicitDrag>;
template class DraggedSkeleton<2, ExplicitDrag>;
template class DraggedSkeleton<3, ExplicitDrag>;
template class MovingSkeleton<2>;
template class MovingSkeleton<3>;

}  // namespace wetfront::mpm
