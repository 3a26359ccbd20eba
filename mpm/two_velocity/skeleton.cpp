#include "mpm/two_velocity/skeleton.h"

#include "mpm/grid/column_vector.h"
#include "mpm/lanes.h"
#include "mpm/two_velocity/water.h"

namespace wetfront::mpm {

template <int dim, class Drag>
Velocities<dim> RestingSkeleton<dim, Drag>::driven(const TwoVelocityWater<dim>& water, std::size_t i, double mobility,
                                                   double dt) const {
  NodalDrag<> node;
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
MovingSkeleton<dim>::MovingSkeleton(StagePlan<dim>& plan, const SkeletonCycle<dim>& cycle)
    : cycle_(cycle),
      velocity_(plan.require_on_nodes("velocity")),
      mass_(plan.require_on_nodes("mass")),
      force_(plan.require_on_nodes("force")),
      acceleration_(plan.require_on_nodes("acceleration")),
      free_(plan.provide_on_nodes({"acceleration of both phases", "a", "m/s2", dim, Lifetime::step})) {}

template <int dim>
Vector<dim> MovingSkeleton<dim>::velocity(std::size_t i) const {
  Vector<dim> v{};
  for (int a = 0; a < dim; ++a) v[a] = velocity_[a][i];
  return v;
}

/// One axis of a node, or of four, before anything is said of the skeleton's momentum.
template <int dim, class Drag>
template <class Number>
NodalDrag<Number> DraggedSkeleton<dim, Drag>::before_drag(const TwoVelocityWater<dim>& water, std::size_t i, int axis,
                                                          const Number& per_force, const Number& drag) const {
  NodalDrag<Number> node;
  node.before = load<Number>((*water.velocity)[axis] + i);
  node.solid_before = load<Number>(this->velocity_[axis] + i);
  node.pushed = node.before + per_force * load<Number>((*water.force)[axis] + i);
  node.drag = drag;
  return node;
}

/// Two equations per axis (d = dt r, m = m_l/m_s, a = F/m_s with the force F on both phases), drag as `Drag` says:
///   v_l' = v_l + dt F_l/(rho_l V) - d (v_l - v_s),   v_s' + m v_l' = v_s + m v_l + dt a.
template <int dim, class Drag>
Velocities<dim> DraggedSkeleton<dim, Drag>::driven(const TwoVelocityWater<dim>& water, std::size_t i, double mobility,
                                                   double dt) const {
  const double content = (*water.content)[0][i], volume = (*water.volume)[0][i], mass = this->mass_[0][i];
  const double drag = dt * content / (mobility * water.density), ratio = water.density * volume * content / mass;
  const double per_force = dt / (water.density * (*water.flow_volume)[0][i]);
  Velocities<dim> v;
  for (int a = 0; a < dim; ++a) {
    const bool held = this->fixed(a, i);
    NodalDrag<> node = before_drag(water, i, a, per_force, drag);
    node.both = held ? 0 : node.solid_before + ratio * node.before + dt * this->free_[a][i];
    node.ratio = held ? 0 : ratio;
    v.liquid[a] = Drag::liquid(node);
    v.solid[a] = held ? 0 : node.both - ratio * v.liquid[a];
  }
  return v;
}

template <int dim, class Drag>
Vector<dim> DraggedSkeleton<dim, Drag>::liquid_against(const TwoVelocityWater<dim>& water, std::size_t i,
                                                       const Vector<dim>& solid, double dt) const {
  const double drag = dt * (*water.content)[0][i] / ((*water.mobility)[0][i] * water.density);
  const double per_force = dt / (water.density * (*water.flow_volume)[0][i]);
  Vector<dim> v{};
  for (int a = 0; a < dim; ++a) {
    NodalDrag<> node = before_drag(water, i, a, per_force, drag);
    node.both = solid[a];  // whatever the liquid does to it
    v[a] = Drag::liquid(node);
  }
  return v;
}

template <int dim, class Drag>
void DraggedSkeleton<dim, Drag>::solve(const TwoVelocityWater<dim>& water, const NodeRun& run, double dt) {
  in_lanes(run.first, run.last, [&]<class Number>(std::size_t i) { drag_freely<Number>(water, i, dt); });
}

template <int dim, class Drag>
template <class Number>
void DraggedSkeleton<dim, Drag>::drag_freely(const TwoVelocityWater<dim>& water, std::size_t i, double dt) {
  const auto at = [i](const Column& column) { return load<Number>(column[0] + i); };
  const Number content = at(*water.content), volume = at(*water.volume), mass = at(this->mass_);
  const Number drag = dt * content / (at(*water.mobility) * water.density);
  const Number ratio = water.density * volume * content / mass;
  const Number per_force = dt / (water.density * at(*water.flow_volume));
  for (int a = 0; a < dim; ++a) {
    const Number free = load<Number>(this->acceleration_[a] + i);
    store(free, this->free_[a] + i);
    NodalDrag<Number> node = before_drag(water, i, a, per_force, drag);
    node.ratio = ratio;
    node.both = node.solid_before + ratio * node.before + dt * free;
    const Number liquid = Drag::liquid(node);
    store(liquid, (*water.velocity_new)[a] + i);
    store((node.both - ratio * liquid - node.solid_before) / dt, this->acceleration_[a] + i);
  }
}

template <int dim, class Drag>
void DraggedSkeleton<dim, Drag>::solve_held(const TwoVelocityWater<dim>& water, std::size_t i, double dt) {
  if (water.walls.any(i)) {
    // A wall carries the pressure against it: it would else be shared out between the phases and come back askew
    // where the skeleton is held along one axis.
    Vector<dim> force = at<dim>(*water.force, i);
    water.walls.project(i, force);
    put<dim>(*water.force, i, force);
  }
  Velocities<dim> v = driven(water, i, (*water.mobility)[0][i], dt);
  if (water.walls.any(i)) {
    Vector<dim> change{}, relative{};
    for (int a = 0; a < dim; ++a) change[a] = relative[a] = v.liquid[a] - v.solid[a];
    water.walls.project(i, relative);
    for (int a = 0; a < dim; ++a) change[a] = relative[a] - change[a];
    MovingSkeleton<dim>::change_relative(water, i, change, v);
  }
  put<dim>(*water.velocity_new, i, v.liquid);
  MovingSkeleton<dim>::set_new(i, v.solid, dt);
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
