#include "mpm/boundary/frictional_contact.h"

#include "mpm/boundary/skeleton_side.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace wetfront::mpm {

template <int dim>
ContactCondition<dim>::ContactCondition(StagePlan<dim>& plan, SkeletonCycle<dim>& cycle,
                                        const std::vector<FrictionalContact>& sides)
    : plan_(plan), cycle_(cycle), nodes_(plan), gaps_(plan) {
  struct Plane {
    Vector<dim> normal;
    double friction, area;
  };
  std::map<int, std::vector<Plane>> found;
  for (const FrictionalContact& side : sides)
    for (const auto& node : side_nodes(plan, side.side, "frictional contact", side.origin, false))
      for (const auto& plane : node.planes) found[node.index].push_back({plane.normal, side.friction, plane.area});
  for (const auto& [index, planes] : found) {
    Node node;
    node.index = static_cast<std::size_t>(index);
    node.first = normal_.size();
    for (int a = 0; a < dim; ++a) {
      const auto& fixed = cycle.fixed[static_cast<std::size_t>(a)];
      node.held[a] = node.index < fixed.size() && fixed[node.index] != 0;
    }
    for (const Plane& plane : planes) {
      Vector<dim> normal = plane.normal;
      for (int a = 0; a < dim; ++a)
        if (node.held[a]) normal[a] = 0;
      const double free = length<dim>(normal);
      if (free < 1e-6) continue;  // held along the normal anyway
      for (double& component : normal) component /= free;
      gaps_.add_plane(node.index, normal);
      normal_.push_back(normal);
      friction_.push_back(plane.friction);
      area_.push_back(plane.area);
    }
    node.count = normal_.size() - node.first;
    if (node.count > 0) base_.push_back(node);
  }
  impulse_.assign(normal_.size(), 0.0);
  approach_ = impulse_;
  gaps_.finish();
  // Where the liquid has a momentum balance of its own, it has made the accelerations by then.
  const bool two_velocities =
      plan.stage.liquid == LiquidScheme::implicit_drag || plan.stage.liquid == LiquidScheme::explicit_drag;
  const bool damping = plan.stage.motion == SkeletonMotion::quasi_static || plan.stage.local_damping > 0;
  damped_ = damping && !two_velocities;
  if (!plan.stage.liquid) return;
  if (two_velocities) {
    plan.at_ready([this] {
      ColumnSet& nodes = plan_.fields.grid.columns;
      liquid_ = {&nodes.at("pressure"), &nodes.at("nodal water content"), &nodes.at("occupied volume"),
                 &nodes.at("volume of flow")};
    });
    return;
  }
  volume_ = &plan.require_on_points("volume");
  wall_pressure_.assign(plan.fields.grid.node_count(), 0.0);
  weight_ = wall_pressure_;
  // The liquid's effect joins later: columns are looked up when the stage begins.
  plan.at_ready([this] {
    const auto there = [](const ColumnSet& set, const char* name) -> const Column* {
      const Column* column = set.find(name);
      return column != nullptr && !column->provided_by().empty() ? column : nullptr;
    };
    pore_stress_ = there(plan_.fields.points.columns, "pore stress");
    node_pressure_ = there(plan_.fields.grid.columns, "pressure");
  });
}

template <int dim>
void ContactCondition<dim>::find_wall_pressure() {
  for (const Node& node : base_) wall_pressure_[node.index] = weight_[node.index] = 0;
  for (const Block& block : plan_.fields.points.blocks()) {
    double volume = 0, pushed = 0;
    for (std::size_t p = block.first; p < block.first + block.count; ++p) {
      volume += (*volume_)[0][p];
      pushed += (*volume_)[0][p] * (*pore_stress_)[0][p];
    }
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      wall_pressure_[static_cast<std::size_t>(block.nodes[i])] += pushed;
      weight_[static_cast<std::size_t>(block.nodes[i])] += volume;
    }
  }
  for (const Node& node : base_)
    if (weight_[node.index] > 0) wall_pressure_[node.index] /= weight_[node.index];
  // Where the node itself is under water its own pressure is the wall's; the mean over its cells lies half a cell
  // above.
  if (node_pressure_ == nullptr) return;
  for (const Node& node : base_)
    if (const double p = (*node_pressure_)[0][node.index]; p > 0) wall_pressure_[node.index] = p;
}

/// Two velocities: nothing passes the base, so it stops the liquid with the skeleton; and what of the node's area is
/// wetted by soil bears S p.
template <int dim>
typename ContactCondition<dim>::Wet ContactCondition<dim>::wet(const Node& node) const {
  const double mass = nodes_.mass[0][node.index];
  if (liquid_.pressure == nullptr) return {mass, wall_pressure_.empty() ? 0 : wall_pressure_[node.index]};
  const double p = (*liquid_.pressure)[0][node.index], content = (*liquid_.content)[0][node.index],
               volume = (*liquid_.volume)[0][node.index];
  if (!(volume > 0)) return {mass, 0};
  const Problem<dim>& problem = plan_.problem;
  const double pores = 1 - mass / (problem.soils.front().grain_density * volume);
  const double saturation = p > 0 ? 1 : std::min(1.0, content / pores);
  const double filled = std::min(1.0, volume / (*liquid_.extent)[0][node.index]);
  return {mass + problem.water->density * volume * content, filled * saturation * p};
}

template <int dim>
void ContactCondition<dim>::find_gaps() {
  gaps_.find();
  for (std::size_t k = 0; k < approach_.size(); ++k) approach_[k] = gaps_.gaps()[k] / cycle_.dt;
}

template <int dim>
RigidPlanes<dim> ContactCondition<dim>::planes(const Node& node) const {
  return {{normal_.data() + node.first, node.count}, {approach_.data() + node.first, node.count}};
}

template <int dim>
std::span<double> ContactCondition<dim>::impulse(const Node& node) {
  return {impulse_.data() + node.first, node.count};
}

/// Friction brakes what of the velocity is along the planes that bear; what closes a gap stays.
template <int dim>
void ContactCondition<dim>::stop_at_planes(Node& node, Vector<dim>& v, double dt) {
  v = without_penetration<dim>(v, planes(node), impulse(node));
  double grip = 0;
  const Wet with = wet(node);
  for (std::size_t k = node.first; k < node.first + node.count; ++k) {
    if (!(impulse_[k] > 0)) continue;
    const double water = with.pressure * area_[k] * dt / with.mass;
    grip += friction_[k] * std::max(impulse_[k] - water, 0.0);
  }
  node.sticks = false;
  if (!(grip > 0)) return;
  const Vector<dim> along = along_planes<dim>(v, planes(node), impulse(node));
  const double speed = length<dim>(along);
  node.sticks = speed <= grip;
  const double lost = node.sticks ? 1 : grip / speed;
  for (int a = 0; a < dim; ++a) v[a] -= lost * along[a];
  if (node.sticks) node.stuck = v;
}

template <int dim>
void ContactCondition<dim>::see_force() {
  if (!damped_) return;
  for (Node& node : base_)
    for (int a = 0; a < dim; ++a) node.force[a] = nodes_.force[a][node.index];
}

/// Local damping of what is left of the force: v' = v + dt (a - d |a| sign v), kept out of the base.
template <int dim>
void ContactCondition<dim>::damp(const Node& node, Vector<dim>& v) {
  for (int a = 0; a < dim; ++a) {
    const double before = nodes_.velocity[a][node.index];
    if (!node.held[a] && before != 0) v[a] -= cycle_.damping * std::copysign(std::abs(v[a] - before), before);
  }
  v = without_penetration<dim>(v, planes(node), impulse(node));
}

template <int dim>
void ContactCondition<dim>::limit_acceleration() {
  if (pore_stress_ != nullptr) find_wall_pressure();
  find_gaps();
  const double dt = cycle_.dt;
  for (Node& node : base_) {
    node.sticks = false;
    if (nodes_.empty(node.index)) continue;
    const double mass = nodes_.mass[0][node.index];
    Vector<dim> v{};
    for (int a = 0; a < dim; ++a)
      if (!node.held[a])
        v[a] =
            nodes_.velocity[a][node.index] + dt * (damped_ ? node.force[a] / mass : nodes_.acceleration[a][node.index]);
    stop_at_planes(node, v, dt);
    if (damped_ && !node.sticks) damp(node, v);
    for (int a = 0; a < dim; ++a)
      if (!node.held[a]) nodes_.acceleration[a][node.index] = (v[a] - nodes_.velocity[a][node.index]) / dt;
  }
}

template <int dim>
void ContactCondition<dim>::limit_velocity() {
  // With the stress first this comes before the accelerations, which say who sticks.
  const bool known = plan_.problem.skeleton.update != StressUpdate::usf;
  if (!known) find_gaps();
  for (const Node& node : base_) {
    if (nodes_.empty(node.index)) continue;
    Vector<dim> v{};
    for (int a = 0; a < dim; ++a)
      if (!node.held[a]) v[a] = nodes_.velocity[a][node.index];
    v = known && node.sticks ? node.stuck : without_penetration<dim>(v, planes(node), impulse(node));
    for (int a = 0; a < dim; ++a)
      if (!node.held[a]) nodes_.velocity[a][node.index] = v[a];
  }
}

template class ContactCondition<2>;
template class ContactCondition<3>;

}  // namespace wetfront::mpm
