#include "mpm/two_velocity/rain.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/record/water_ledger.h"
#include "mpm/two_velocity/nodal_vector.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace wetfront::mpm {

template <int dim>
double RainOnTwoVelocity<dim>::normal_part(const Node& node, const Velocities<dim>& v) {
  double sum = 0;
  for (int a = 0; a < dim; ++a) sum += (v.liquid[a] - v.solid[a]) * node.normal[a];
  return sum;
}

template <int dim>
void RainOnTwoVelocity<dim>::collect(const StagePlan<dim>& plan) {
  std::map<std::size_t, Node> found;
  for (const auto& boundary : plan.problem.water_boundary) {
    const auto* rain = std::get_if<RainSide>(&boundary);
    if (rain == nullptr) continue;
    if (rain->side == free_surface) {
      if (!water_->surface)
        throw CannotPlan(rain->origin +
                         ": rain falls on the free surface, but the problem has no surface in its cells. "
                         "Give it one, or name a side of the mesh");
      rains_.push_back(*rain);
      continue;
    }
    const auto side = boundary_side(plan, rain->side, "rainfall", rain->origin);
    const auto areas = open_areas(side, plan.problem, *rain);
    for (std::size_t k = 0; k < side.nodes.size(); ++k) {
      const auto index = static_cast<std::size_t>(side.nodes[k].index);
      Node& node = found[index];
      node.index = index;
      for (int a = 0; a < dim; ++a) node.normal[a] += side.nodes[k].area[a];
      node.rains.emplace_back(rains_.size(), areas[k]);
      const Soil& soil = plan.problem.soils[static_cast<std::size_t>(side.nodes[k].region)];
      node.mobility = soil.intrinsic_permeability / plan.problem.water->viscosity;
    }
    rains_.push_back(*rain);
  }
  for (auto& [index, node] : found) {
    double square = 0, open = 0;
    for (double component : node.normal) square += component * component;
    node.area = std::sqrt(square);
    for (double& component : node.normal) component /= node.area;
    node.along = node.normal;
    water_->walls.project(index, node.along);
    for (int a = 0; a < dim; ++a) open += node.along[a] * node.normal[a];
    // A hundredth: the walls at the node would have to lie within a degree of the surface itself.
    if (open < 0.01)
      throw CannotPlan(rains_[node.rains.front().first].origin + ": rain falls on a node (" + std::to_string(index) +
                       ") that impermeable sides close in all directions it could take, so it cannot enter there. Let "
                       "the rained side include all faces at that node");
    for (double& component : node.along) component /= open;
    nodes_.push_back(node);
    water_->unmapped.emplace_back(index, node.normal);
  }
}

/// Rain that reaches a node [m^dim/s].
template <int dim>
double RainOnTwoVelocity<dim>::rate(const Node& node, double time) const {
  double total = 0;
  for (const auto& [rain, area] : node.rains) total += area * meshes::intensity_after(rains_[rain].rain, time);
  return total;
}

/// Step II: decides the flux through the surface and corrects the new velocity.
template <int dim>
void RainOnTwoVelocity<dim>::correct(double time, double dt) {
  TwoVelocityWater<dim>& w = *water_;
  for (Node& node : nodes_) {
    const std::size_t i = node.index;
    const double content = (*w.content)[0][i], rain = rate(node, time) / node.area;
    Velocities<dim> capacity = w.skeleton->driven(w, i, node.mobility, dt);
    w.keep_to_walls(i, capacity);
    if (normal_part(node, capacity) > 0) {
      // Water leaves through the surface with the conductivity that the soil behind it has: none to speak of when dry.
      capacity = w.skeleton->driven(w, i, (*w.cell_mobility)[0][i], dt);
      w.keep_to_walls(i, capacity);
    }
    const double residual = content * normal_part(node, capacity) + rain;
    const bool ponded = residual >= 0;
    (*ponded_)[0][i] = ponded ? 1 : 0;
    node.flux = ponded ? residual - rain : -rain;
    Velocities<dim> v = capacity;
    if (!ponded) {
      for (int a = 0; a < dim; ++a) v.liquid[a] = (*w.velocity_new)[a][i];
      v.solid = w.skeleton->get_new(i, dt);
      Vector<dim> change = node.along;
      for (double& component : change) component *= node.flux / content - normal_part(node, v);
      w.skeleton->change_relative(w, i, change, v);
    }
    for (int a = 0; a < dim; ++a) (*w.velocity_new)[a][i] = v.liquid[a];
    w.skeleton->set_new(i, v.solid, dt);
  }
}

/// Step III: mapping points back blurs the surface velocity; its normal part is what step II decided. (Only the liquid
/// is corrected: the skeleton's nodal velocity has moved its points already.)
template <int dim>
void RainOnTwoVelocity<dim>::restore() {
  TwoVelocityWater<dim>& w = *water_;
  for (const Node& node : nodes_) {
    const Velocities<dim> v{at<dim>(*w.velocity, node.index), w.skeleton->velocity(node.index)};
    const double missing = node.flux / (*w.content)[0][node.index] - normal_part(node, v);
    for (int a = 0; a < dim; ++a) (*w.velocity)[a][node.index] += missing * node.along[a];
  }
}

/// Step VII: a ponded surface is at p = 0 and saturated; elsewhere p follows from the flux that enters,
/// grad p.n = rho g.n - w.n mu/(k k_rel), and stays below zero.
template <int dim>
void RainOnTwoVelocity<dim>::surface_state() {
  TwoVelocityWater<dim>& w = *water_;
  for (const Node& node : nodes_) {
    const std::size_t i = node.index;
    double& p = (*w.pressure)[0][i];
    if ((*ponded_)[0][i] != 0) {
      p = 0;
      (*w.mobility)[0][i] = node.mobility;
    } else {
      const double flux = dot<dim>(at<dim>(*w.flux, i), node.normal);
      p = std::min(p - flux / (*w.cell_mobility)[0][i] * dot<dim>(at<dim>(*w.offset, i), node.normal), 0.0);
    }
  }
}

/// The step limit looks ahead at the rain of the coming step.
template <int dim>
void RainOnTwoVelocity<dim>::anticipate(double time) {
  for (const Node& node : nodes_) (*water_->rain_rate)[0][node.index] = rate(node, time);
}

template <int dim>
void RainOnTwoVelocity<dim>::book(double time, double dt) {
  for (const Node& node : nodes_) {
    const double taken = std::max(-node.flux, 0.0) * node.area;
    (*imposed_)[0][node.index] += taken * dt;
    (*run_off_)[0][node.index] += (rate(node, time) - taken) * dt;
    (*outflow_)[0][node.index] += std::max(node.flux, 0.0) * node.area * dt;
  }
  if (water_->surface) book_pieces();
}

/// Rain on pieces of the free surface, to the nodes by the weights of the piece.
template <int dim>
void RainOnTwoVelocity<dim>::book_pieces() {
  for (const auto& piece : water_->surface->pieces())
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      const double weight = piece.weight[static_cast<std::size_t>(i)];
      const int node = grid_->cell_nodes_of(piece.cell)[i];
      (*on_pieces_)[0][node] += weight * piece.asked;
      (*imposed_)[0][node] += weight * piece.taken;
      (*run_off_)[0][node] += weight * (piece.asked - piece.taken);
    }
}

template <int dim>
void RainOnTwoVelocity<dim>::fill_ledger(double time) {
  if (water_->surface)
    std::ranges::copy(on_pieces_->values(), asked_->values().begin());
  else
    asked_->fill(0);
  for (const Node& node : nodes_) {
    for (const auto& [rain, area] : node.rains)
      (*asked_)[0][node.index] += area * meshes::depth_until(rains_[rain].rain, time);
  }
  (*ledger_)[ledger_rain_asked][0] = asked_->sum();
  (*ledger_)[ledger_infiltrated][0] = imposed_->sum();
  (*ledger_)[ledger_run_off][0] = run_off_->sum();
  (*ledger_)[ledger_outflow][0] = outflow_->sum();  // what seeps out of the rained surface is booked here
}

template <int dim>
void RainOnTwoVelocity<dim>::join(StagePlan<dim>& plan) {
  const std::string volume = dim == 2 ? "m2" : "m3";
  asked_ = &plan.provide_on_nodes({"rain asked", "Q_rain", volume});
  imposed_ = &plan.provide_on_nodes({"rain imposed", "Q_in", volume});
  run_off_ = &plan.provide_on_nodes({"rain run-off", "Q_run", volume});
  ponded_ = &plan.provide_on_nodes({"ponded surface", "-", "-"});
  outflow_ = &plan.require_on_nodes("outflow");
  ledger_ = &plan.require_on_run("water ledger");
  plan.require_on_points("liquid velocity");
  if (water_->surface) on_pieces_ = &plan.provide_on_nodes({"rain asked of pieces", "Q_rain", volume});
  grid_ = &plan.fields.grid;
  collect(plan);
  for (const RainSide& rain : rains_)
    for (double start : rain.rain.start) plan.add_break(start);
  plan.add(Phase::accelerate, "rainfall", [this, &plan] { correct(plan.clock.time, plan.clock.dt); });
  plan.add(Phase::point_velocity, "rainfall after mapping back", [this] { restore(); });
  plan.add(water_->conductivities_in, "rained surface", [this, &plan] {
    surface_state();
    anticipate(plan.clock.end);
  });
  plan.at_ready([this] { surface_state(); });
  plan.at_begin([this, &plan] { anticipate(plan.begin_time()); });
  plan.add(Phase::carry, "rain ledger", [this, &plan] {
    book(plan.clock.time, plan.clock.dt);
    fill_ledger(plan.clock.end);
  });
  plan.at_finish([this, &plan](meshes::FieldHistory& history) {
    history.rain_by_node.clear();
    for (const Node& node : nodes_)
      history.rain_by_node.push_back({static_cast<int>(node.index), plan.problem.mesh.nodes[node.index],
                                      (*asked_)[0][node.index], (*imposed_)[0][node.index],
                                      (*run_off_)[0][node.index]});
  });
}

template class RainOnTwoVelocity<2>;
template class RainOnTwoVelocity<3>;

}  // namespace wetfront::mpm
