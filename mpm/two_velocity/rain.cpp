#include "mpm/two_velocity/rain.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/grid/column_vector.h"
#include "mpm/laws/soil_water.h"
#include "mpm/record/water_ledger.h"
#include "mpm/two_velocity/moving_liquid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace wetfront::mpm {

namespace {

/// Not merely a seepage face.
bool falls(const RainSide& rain) {
  return std::any_of(rain.rain.intensity.begin(), rain.rain.intensity.end(), [](double i) { return i > 0; });
}

}  // namespace

template <int dim>
double RainOnTwoVelocity<dim>::normal_part(const Node& node, const Velocities<dim>& v) {
  double sum = 0;
  for (int a = 0; a < dim; ++a) sum += (v.liquid[a] - v.solid[a]) * node.normal[a];
  return sum;
}

template <int dim>
void RainOnTwoVelocity<dim>::collect(const StagePlan<dim>& plan) {
  std::map<std::size_t, Node> found;
  rain_of_boundary_.assign(plan.problem.water_boundary.size(), -1);
  for (const auto& boundary : plan.problem.water_boundary) {
    const auto* rain = std::get_if<RainSide>(&boundary);
    if (rain == nullptr) continue;
    if (water_->body != nullptr) {
      rain_of_boundary_[static_cast<std::size_t>(&boundary - plan.problem.water_boundary.data())] =
          static_cast<int>(rains_.size());
      if (rain->side != free_surface)  // that there is soil, and that rain can fall on it
        open_areas(boundary_side(plan, rain->side, "rainfall", rain->origin), plan.problem, *rain);
      rains_.push_back(*rain);
      continue;
    }
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
    settle(node);
    nodes_.push_back(node);
  }
}

/// Normal, area and direction of the correction of a node whose faces have been added up.
template <int dim>
void RainOnTwoVelocity<dim>::settle(Node& node) {
  double open = 0;
  node.area = length<dim>(node.normal);
  for (double& component : node.normal) component /= node.area;
  node.along = node.normal;
  water_->walls.project(node.index, node.along);
  for (int a = 0; a < dim; ++a) open += node.along[a] * node.normal[a];
  // A hundredth: the walls at the node would have to lie within a degree of the surface itself.
  node.closed = open < 0.01;
  if (node.closed && water_->body == nullptr)
    throw CannotPlan(rains_[node.rains.front().first].origin + ": rain falls on a node (" + std::to_string(node.index) +
                     ") that impermeable sides close in all directions it could take, so it cannot enter there. Let "
                     "the rained side include all faces at that node");
  for (double& component : node.along) component = node.closed ? 0 : component / open;
  water_->unmapped.emplace_back(node.index, node.normal);
}

/// Of a body that moves: the outer faces that rain finds now (body.h). Where walls close a node in all directions its
/// rain runs off: steps of a surface that lies inside cells.
template <int dim>
void RainOnTwoVelocity<dim>::collect_from_body(const StagePlan<dim>& plan) {
  const Grid<dim>& grid = plan.fields.grid;
  const Vector<dim> up = upward(plan.problem);
  for (const Node& node : nodes_) place_of_node_[node.index] = -1;
  place_of_node_.resize(grid.node_count(), -1);
  std::ranges::move(nodes_, std::back_inserter(spare_));  // their lists keep their room
  nodes_.clear();
  for (const auto& outer : water_->body->outer()) {
    if (outer.rains.empty()) continue;
    const auto local = local_face<dim>(outer.face);
    const auto integrals = Faces<dim>::integrals(grid, outer.cell, outer.face);
    const Soil& soil = plan.problem.soils[static_cast<std::size_t>(grid.region(outer.cell))];
    for (std::size_t k = 0; k < local.size(); ++k) {
      const auto index = static_cast<std::size_t>(grid.cell_nodes_of(outer.cell)[local[k]]);
      Node& node = node_at(index);
      node.mobility = soil.intrinsic_permeability / plan.problem.water->viscosity;
      node.cells.push_back(outer.cell);
      for (int a = 0; a < dim; ++a) node.normal[a] += integrals[k][a];
      for (int boundary : outer.rains) {
        const auto rain = static_cast<std::size_t>(rain_of_boundary_[static_cast<std::size_t>(boundary)]);
        const double open = falls(rains_[rain]) ? std::max(0.0, dot<dim>(integrals[k], up)) : length<dim>(integrals[k]);
        const auto same = std::find_if(node.rains.begin(), node.rains.end(),
                                       [rain](const auto& other) { return other.first == rain; });
        if (same == node.rains.end())
          node.rains.emplace_back(rain, open);
        else
          same->second += open;
      }
    }
  }
  std::ranges::sort(nodes_, {}, &Node::index);
  water_->unmapped.clear();
  for (Node& node : nodes_) settle(node);
}

/// The node of nodes_ with this index, a new one where there is none.
template <int dim>
typename RainOnTwoVelocity<dim>::Node& RainOnTwoVelocity<dim>::node_at(std::size_t index) {
  int& place = place_of_node_[index];
  if (place >= 0) return nodes_[static_cast<std::size_t>(place)];
  place = static_cast<int>(nodes_.size());
  if (spare_.empty())  // as many again: a body that spreads asks for more now and then, not one by one
    for (std::size_t more = nodes_.size() + 8; more-- > 0;) {
      spare_.emplace_back();
      spare_.back().cells.reserve(cell_nodes<dim> * dim);  // faces of cells at a node
      spare_.back().rains.reserve(rains_.size());
    }
  Node fresh;
  fresh.index = index;
  fresh.cells.swap(spare_.back().cells), fresh.rains.swap(spare_.back().rains);
  fresh.cells.clear(), fresh.rains.clear();
  spare_.pop_back();
  return nodes_.emplace_back(std::move(fresh));
}

/// A rain that finds no face of the body any more stops the run.
template <int dim>
void RainOnTwoVelocity<dim>::refuse_to_miss(double time) const {
  for (std::size_t k = 0; k < rains_.size(); ++k) {
    const auto meets = [k](const Node& node) {
      return std::any_of(node.rains.begin(), node.rains.end(), [k](const auto& rain) { return rain.first == k; });
    };
    if (std::any_of(nodes_.begin(), nodes_.end(), meets)) continue;
    if (!(time > 0))  // nothing has moved yet
      throw CannotPlan(rains_[k].origin + ": rain on '" + rains_[k].side +
                       "' finds no soil (two velocities in a deforming skeleton rain on cells in front of empty ones). "
                       "Let the mesh go on above the soil by a row of cells, or rain on a side of the mesh");
    const std::string what = rains_[k].origin + ": rain on '" + rains_[k].side + "' finds no soil at " +
                             std::to_string(time) +
                             " s (the body has moved away from it, or lies nowhere open to the "
                             "sky). Let it rain on the free surface, or end the stage before";
    throw StepFailed(what);
  }
}

template <int dim>
bool RainOnTwoVelocity<dim>::may_leave(const Node& node) const {
  return std::all_of(node.cells.begin(), node.cells.end(),
                     [this](std::size_t cell) { return water_->liquid->lowest_pressure(cell) > nearly_full_; });
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
    if (node.closed) {
      (*ponded_)[0][i] = 1;
      node.flux = 0;
      if (w.body != nullptr) close(i, dt);
      continue;
    }
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
    const bool held_back = node.flux > 0 && !may_leave(node);
    if (held_back) node.flux = 0;
    Velocities<dim> v = capacity;
    if (!ponded || held_back) {
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

/// The little that walls leave open at a node is closed too: what passed there would be in no ledger.
template <int dim>
void RainOnTwoVelocity<dim>::close(std::size_t i, double dt) {
  TwoVelocityWater<dim>& w = *water_;
  Velocities<dim> v{at<dim>(*w.velocity_new, i), w.skeleton->get_new(i, dt)};
  Vector<dim> against{};
  for (int a = 0; a < dim; ++a) against[a] = v.solid[a] - v.liquid[a];
  w.skeleton->change_relative(w, i, against, v);
  put<dim>(*w.velocity_new, i, v.liquid);
  w.skeleton->set_new(i, v.solid, dt);
}

/// Step III: mapping points back blurs the surface velocity; its normal part is what step II decided. (Only the liquid
/// is corrected: the skeleton's nodal velocity has moved its points already.)
template <int dim>
void RainOnTwoVelocity<dim>::restore() {
  TwoVelocityWater<dim>& w = *water_;
  for (const Node& node : nodes_) {
    if (node.closed) {
      if (w.body != nullptr) put<dim>(*w.velocity, node.index, w.skeleton->velocity(node.index));
      continue;
    }
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
    if (water_->body != nullptr) (*on_pieces_)[0][node.index] += rate(node, time) * dt;
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
  if (on_pieces_ != nullptr)
    std::ranges::copy(on_pieces_->values(), asked_->values().begin());
  else
    asked_->fill(0);
  for (const Node& node : nodes_) {
    if (water_->body != nullptr) break;  // what fell is what the steps brought: the areas change
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
  if (water_->surface || water_->body != nullptr) {
    const bool fresh = plan.fields.grid.columns.find_allocated("rain asked of pieces") == nullptr;
    on_pieces_ = &plan.provide_on_nodes({"rain asked of pieces", "Q_rain", volume});
    // What the stages before were asked for counts on.
    if (fresh && water_->body != nullptr)
      plan.at_entry([this] { std::ranges::copy(asked_->values(), on_pieces_->values().begin()); });
  }
  grid_ = &plan.fields.grid;
  collect(plan);
  if (water_->body != nullptr) {
    for (const Soil& soil : plan.problem.soils)
      nearly_full_ =
          std::max(nearly_full_, -0.05 * tabulated_soil_water(soil, *plan.problem.water).curve.pressure_scale());
    collect_from_body(plan);
    refuse_to_miss(0);
    water_->liquid->at_other_body([this, &plan] {
      collect_from_body(plan);
      refuse_to_miss(plan.clock.end);
    });
  }
  for (const RainSide& rain : rains_)
    for (double start : rain.rain.start) plan.add_break(start);
  const auto decide = [this, &plan] { correct(plan.clock.time, plan.clock.dt); };
  // Where the skeleton moves, before contact and sides have their say, and seen by the ledger of motion.
  if (water_->body != nullptr)
    water_->liquid->after_solve(decide);
  else
    plan.add(Phase::accelerate, "rainfall", decide);
  plan.add(Phase::point_velocity, "rainfall after mapping back", [this] { restore(); });
  plan.add(water_->conductivities_in, "rained surface", [this, &plan] {
    surface_state();
    anticipate(plan.clock.end);
  });
  plan.at_ready([this] { surface_state(); });
  plan.at_begin([this, &plan] { anticipate(plan.begin_time()); });
  // Before points change cells: the nodes of another body know nothing of this step.
  plan.add(Phase::pressure, "rain and run-off", [this, &plan] { book(plan.clock.time, plan.clock.dt); });
  plan.add(Phase::carry, "rain ledger", [this, &plan] { fill_ledger(plan.clock.end); });
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
