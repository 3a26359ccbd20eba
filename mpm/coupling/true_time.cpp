#include "mpm/coupling/true_time.h"

#include "mpm/laws/linear_elastic.h"
#include "mpm/skeleton/rigid_skeleton.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace wetfront::mpm {

namespace {

/// Cycles of the skeleton in a step of the flow: the pressure of a saturated cell of sand evens out in about as long.
constexpr double cycles_per_step = 16;
/// Nodes this close to zero pressure answer like full ones.
constexpr double nearly_full = 100;  // Pa

/// Mean of grad N_i over a cell, 2^dim Gauss points: exact in the plane.
template <int dim>
std::array<Vector<dim>, cell_nodes<dim>> mean_slope(const Grid<dim>& grid, std::size_t cell) {
  std::array<Vector<dim>, cell_nodes<dim>> mean{};
  Stencil<dim> s;
  double volume = 0;
  for (int corner = 0; corner < cell_nodes<dim>; ++corner) {
    Vector<dim> xi{};
    for (int a = 0; a < dim; ++a) xi[a] = node_sign(corner, a) / std::sqrt(3.0);
    const double weight = grid.stencil(cell, xi, s);
    volume += weight;
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a) mean[i][a] += weight * s.gradient[i][a];
  }
  for (auto& one : mean)
    for (double& component : one) component /= volume;
  return mean;
}

}  // namespace

template <int dim>
class TrueTimeMotion<dim>::PoreForce : public NodalCondition<dim> {
 public:
  explicit PoreForce(TrueTimeMotion& motion) : motion_(motion) {}
  void add_force() override { motion_.add_pore_force(); }

 private:
  TrueTimeMotion& motion_;
};

template <int dim>
void TrueTimeMotion<dim>::join(StagePlan<dim>& plan, NodalWater<dim>& water, const SeepageColumns& columns,
                               const std::vector<SoilContent>& contents, std::function<void(bool)> refresh) {
  plan_ = &plan;
  water_ = &water;
  c_ = columns;
  contents_ = &contents;
  refresh_ = std::move(refresh);
  for (const SoilContent& content : contents)
    if (!content.compressible())
      throw CannotPlan(plan.stage.origin + ": stage '" + plan.stage.name +
                       "' moves soil with incompressible water in true time (undrained, its pressure would have no "
                       "bound). Give the water its bulk modulus");
  const auto held = [](const Column* column) { return column != nullptr && column->allocated(); };
  fresh_ = !held(plan.fields.points.columns.find("water"));
  const bool weighed = held(plan.fields.points.columns.find("grain mass"));
  value_ = &plan.provide_on_points(shape_value_spec<dim>());
  gradient_ = &plan.provide_on_points(shape_gradient_spec<dim>());
  mass_ = &plan.require_on_points("mass");
  volume_ = &plan.require_on_points("volume");
  force_ = &plan.require_on_nodes("force");
  grains_ = &plan.provide_on_points({"grain mass", "m_s", dim == 2 ? "kg/m" : "kg"});
  pore_stress_ = &plan.provide_on_points({"pore stress", "chi p", "Pa"});
  const bool needs_suction = std::ranges::any_of(plan.problem.soils, [](const Soil& soil) {
    return soil.law && std::holds_alternative<SuctionMohrCoulomb>(*soil.law);
  });
  if (needs_suction) suction_ = &plan.provide_on_points({"suction", "chi s", "Pa"});
  carried_ = std::make_unique<CarriedWater<dim>>(plan, columns, *water.trial, contents, "grain mass");
  water_of_points_ = &plan.require_on_points("water");
  for (std::size_t cell = 0; cell < plan.fields.grid.cell_count(); ++cell) {
    cells_.push_back({{}, mean_slope<dim>(plan.fields.grid, cell)});
    cells_.back().share.fill(1.0 / cell_nodes<dim>);
  }
  cycle_->conditions.push_back(std::make_unique<PoreForce>(*this));
  // At entry "mass" is that of the grains, but after a stage that has weighed its points already.
  if (!weighed) plan.at_entry([this] { std::ranges::copy(mass_->values(), grains_->values().begin()); });
  plan.add_accuracy_limit("flow beside motion", "16 cycles of the skeleton",
                          [this] { return cycles_per_step * longest_cycle(); });
  plan.at_record([this](double, meshes::FieldHistory& history) {
    history.counters["cycles in true time"] += static_cast<double>(std::exchange(cycles_, 0));
  });
}

template <int dim>
void TrueTimeMotion<dim>::add_storage(int region, const SoilContent& content) const {
  const double *pores = (*c_.pore_volume)[region], *p = (*water_->trial)[0];
  double *stored = (*water_->stored)[0], *capacity = (*water_->capacity)[0];
  for (std::size_t i = 0; i < c_.pressure->size(); ++i) {
    if (!(pores[i] > 0)) continue;
    const ValueAndSlope now = content.at(p[i]);
    stored[i] += pores[i] * now.value;
    capacity[i] += pores[i] * now.slope;
  }
}

/// Stencils, pores and all that `Seepage` derives from the points' places.
template <int dim>
void TrueTimeMotion<dim>::refresh_geometry() {
  auto& points = plan_->fields.points;
  c_.pore_volume->fill(0);
  std::vector<std::size_t> occupied;
  for (const Block& block : points.blocks()) {
    fill_stencils<dim>(plan_->fields.grid, points, block, *value_, *gradient_);
    const Soil& soil = carried_->soil_of(block);
    Cell& cell = cells_[block.cell];
    cell.share.fill(0);
    double whole = 0;
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      const double v = (*volume_)[0][q], held = carried_->pores(q, soil);
      whole += v;
      for (int i = 0; i < cell_nodes<dim>; ++i) {
        cell.share[i] += v * (*value_)[i][q];
        (*c_.pore_volume)[block.soil][block.nodes[i]] += held * (*value_)[i][q];
      }
    }
    for (double& share : cell.share) share /= whole;
    occupied.push_back(block.cell);
  }
  const bool changed = occupied != occupied_;
  occupied_ = std::move(occupied);
  refresh_(changed);
}

template <int dim>
void TrueTimeMotion<dim>::ready() {
  std::ranges::copy(c_.pressure->values(), water_->trial->values().begin());
  refresh_geometry();
  press_points();
}

template <int dim>
void TrueTimeMotion<dim>::begin_stage() {
  if (fresh_) carried_->begin();
  weigh_points();
}

template <int dim>
void TrueTimeMotion<dim>::weigh_points() {
  const double density = plan_->problem.water->density;
  for (const Block& block : plan_->fields.points.blocks())
    for (std::size_t q = block.first; q < block.first + block.count; ++q)
      (*mass_)[0][q] = (*grains_)[0][q] + density * (*water_of_points_)[0][q];
}

/// h/c over the cells, c^2 = (E_oed + what the water adds)/density: full pores add (K_l/n), others what their curve
/// lets them. [s]
template <int dim>
double TrueTimeMotion<dim>::longest_cycle() const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Block& block : plan_->fields.points.blocks()) {
    const SoilContent& content = carried_->content_of(block);
    const Soil& soil = carried_->soil_of(block);
    double volume = 0, pores = 0, mass = 0, most = -std::numeric_limits<double>::infinity();
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      volume += (*volume_)[0][q];
      pores += carried_->pores(q, soil);
      mass += (*mass_)[0][q];
    }
    for (int i = 0; i < cell_nodes<dim>; ++i) most = std::max(most, (*c_.pressure)[0][block.nodes[i]]);
    const double slope = std::max(content.at(most + nearly_full).slope, content.at(1.0).slope);
    const double stiffness = LinearElastic(*soil.elastic).constrained_modulus() + volume / (pores * slope);
    const double h = plan_->fields.grid.smallest_altitude(block.cell);
    shortest = std::min(shortest, h * std::sqrt(mass / (volume * stiffness)));
  }
  return plan_->stage.step_safety * std::min(shortest, cycle_->stable_step());
}

/// f_i += V chi p grad N_i with the mean gradient of the cell and its mean pore stress, the adjoint of the volume that
/// answer() sees.
template <int dim>
void TrueTimeMotion<dim>::add_pore_force() {
  const auto blocks = plan_->fields.points.blocks();
  block_volume_.resize(blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    const Cell& cell = cells_[block.cell];
    const std::vector<double>& pores = pores_[static_cast<std::size_t>(block.soil)];
    const SoilContent& content = carried_->content_of(block);
    double volume = 0, push = 0, known = 0;
    for (std::size_t q = block.first; q < block.first + block.count; ++q) volume += (*volume_)[0][q];
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      const auto node = static_cast<std::size_t>(block.nodes[i]);
      if (!(pores[node] > 0)) continue;  // reached since the flow was last solved
      known += cell.share[i];
      push += cell.share[i] * content.pore_stress((*c_.pressure)[0][node]).value;
    }
    block_volume_[b] = volume;
    if (!(known > 0)) continue;
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a) (*force_)[a][block.nodes[i]] += volume * push / known * cell.slope[i][a];
  }
}

/// p_i <- content^-1(P_i' content(p_i)/P_i): the water of a node stays while its pores change from P_i' to P_i.
template <int dim>
double TrueTimeMotion<dim>::answered(std::size_t node) const {
  const double p = (*c_.pressure)[0][node];
  double now = 0, room = 0, grown = 0;
  const SoilContent* content = nullptr;
  for (std::size_t r = 0; r < contents_->size(); ++r) {
    const double pores = pores_[r][node];
    if (!(pores > 0)) continue;
    if (content == nullptr || pores > room) content = &(*contents_)[r];
    now += pores * (*contents_)[r].at(p).value;
    room += pores;
    grown += grown_[r][node];
  }
  if (content == nullptr || grown == 0) return p;
  // As a difference, so that what the table's inverse is off does not add up.
  const double held = now / room;
  return p + content->pressure_at(held * room / (room + grown)) - content->pressure_at(held);
}

template <int dim>
void TrueTimeMotion<dim>::answer() {
  for (auto& region : grown_) std::ranges::fill(region, 0.0);
  const auto blocks = plan_->fields.points.blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    double volume = 0;
    for (std::size_t q = block.first; q < block.first + block.count; ++q) volume += (*volume_)[0][q];
    std::vector<double>& grown = grown_[static_cast<std::size_t>(block.soil)];
    for (int i = 0; i < cell_nodes<dim>; ++i)
      grown[static_cast<std::size_t>(block.nodes[i])] += cells_[block.cell].share[i] * (volume - block_volume_[b]);
  }
  double* p = (*c_.pressure)[0];
  for (std::size_t i = 0; i < c_.pressure->size(); ++i) p[i] = answered(i);
  for (std::size_t r = 0; r < pores_.size(); ++r)
    for (std::size_t i = 0; i < pores_[r].size(); ++i)
      if (pores_[r][i] > 0) pores_[r][i] += grown_[r][i];
}

template <int dim>
void TrueTimeMotion<dim>::move_undrained() {
  Clock& clock = plan_->clock;
  const Clock whole = clock;
  const std::size_t nodes = c_.pressure->size();
  pores_.resize(contents_->size());
  grown_.assign(contents_->size(), std::vector<double>(nodes));
  for (std::size_t r = 0; r < pores_.size(); ++r)
    pores_[r].assign((*c_.pore_volume)[static_cast<int>(r)], (*c_.pore_volume)[static_cast<int>(r)] + nodes);
  for (double time = whole.time; time < whole.end;) {
    const double rest = whole.end - time, parts = std::ceil(rest / longest_cycle() * (1 - 1e-9));
    clock.time = time;
    clock.end = time = parts > 1 ? time + rest / parts : whole.end;
    clock.dt = cycle_->dt = clock.end - clock.time;
    for (Kernel* kernel : {cycle_->gather, cycle_->accelerate, cycle_->points, cycle_->velocity, cycle_->move})
      kernel->run();
    answer();
    cycle_->migrate->run();
    ++cycles_;
  }
  clock = whole;
}

template <int dim>
void TrueTimeMotion<dim>::begin_step() {
  carried_->before_motion();
  start_.assign(c_.pressure->values().begin(), c_.pressure->values().end());
  move_undrained();
  for (std::size_t i = 0; i < start_.size(); ++i) {
    const double now = (*c_.pressure)[0][i];
    (*c_.pressure)[0][i] = start_[i];
    start_[i] = now - start_[i];
  }
  refresh_geometry();
  carried_->after_motion(start_);
  std::ranges::copy(c_.pressure->values(), water_->trial->values().begin());
  // What the nodes hold before the flow.
  c_.stored->fill(0);
  for (std::size_t r = 0; r < contents_->size(); ++r)
    for (std::size_t i = 0; i < start_.size(); ++i)
      if (const double pores = (*c_.pore_volume)[static_cast<int>(r)][i]; pores > 0)
        (*c_.stored)[0][i] += pores * (*contents_)[r].at((*c_.pressure)[0][i]).value;
}

template <int dim>
void TrueTimeMotion<dim>::end_step() {
  carried_->take_increments();
  weigh_points();
  press_points();
}

template <int dim>
void TrueTimeMotion<dim>::press_points() {
  for (const Block& block : plan_->fields.points.blocks()) {
    std::array<double, cell_nodes<dim>> push{};
    for (int i = 0; i < cell_nodes<dim>; ++i)
      push[i] = carried_->content_of(block).pore_stress((*c_.pressure)[0][block.nodes[i]]).value;
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      double g = 0;
      for (int i = 0; i < cell_nodes<dim>; ++i) g += (*value_)[i][q] * push[i];
      (*pore_stress_)[0][q] = g;
      if (suction_ != nullptr) (*suction_)[0][q] = std::max(0.0, -g);
    }
  }
}

template class TrueTimeMotion<2>;
template class TrueTimeMotion<3>;

}  // namespace wetfront::mpm
