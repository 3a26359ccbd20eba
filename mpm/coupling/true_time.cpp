#include "mpm/coupling/true_time.h"

#include "mpm/grid/cell_integrals.h"
#include "mpm/grid/column_vector.h"
#include "mpm/grid/soils_of_cells.h"
#include "mpm/laws/linear_elastic.h"
#include "mpm/record/brought_by_water.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace wetfront::mpm {

namespace {

/// Cycles of the skeleton in a step of the flow while the body moves: the pressure of a saturated cell of sand evens
/// out in about as long.
constexpr double fewest_cycles = 16;
/// While it stands: some hundredths of a second, nothing beside rain.
constexpr double most_cycles = 256;
/// With inertia of the water against the grains the flow is solved after every cycle, of this part of the longest one
/// (README section 8b).
constexpr double cycle_with_inertia = 0.75;
/// What seepage may find to even out after a step's undrained motion, for the next step to be longer: a thousandth of
/// the pressures under a metre of water.
constexpr double small_answer = 10;  // Pa
/// Nodes this close to zero pressure answer like full ones.
constexpr double nearly_full = 100;  // Pa

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
void TrueTimeMotion<dim>::join_own() {
  StagePlan<dim>& plan = *plan_;
  for (const SoilContent& content : *contents_)
    if (!content.compressible())
      throw CannotPlan(plan.stage.origin + ": stage '" + plan.stage.name +
                       "' moves soil with incompressible water in true time (undrained, its pressure would have no "
                       "bound). Give the water its bulk modulus");
  mass_ = &plan.require_on_points("mass");
  force_ = &plan.require_on_nodes("force");
  grains_ = &plan.provide_on_points({"grain mass", "m_s", dim == 2 ? "kg/m" : "kg"});
  carried_ = std::make_unique<CarriedWater<dim>>(plan, c_, *water_->trial, *contents_, "grain mass");
  water_of_points_ = &plan.require_on_points("water");
  position_ = &plan.require_on_points("position");
  velocity_ = &plan.require_on_points("velocity");
  brought_ = &plan.provide_on_run(brought_by_water(dim));
  answer_.emplace(*contents_);
  if (c_.acceleration != nullptr) relative_ = std::make_unique<RelativeInertia<dim>>(plan, c_, *cycle_);
  for (std::size_t cell = 0; cell < plan.fields.grid.cell_count(); ++cell) {
    cells_.push_back({{}, mean_gradients(plan.fields.grid, cell)});
    cells_.back().share.fill(1.0 / cell_nodes<dim>);
  }
  cycle_->conditions.push_back(std::make_unique<PoreForce>(*this));
  // At entry "mass" is that of the grains.
  plan.at_entry([this] { std::ranges::copy(mass_->values(), grains_->values().begin()); });
  if (relative_) {
    plan.add_stability_limit("cycle of grains and water", "0.75 h/c, c^2 = (E_oed + dp/dcontent V/P) V/m",
                             [this] { return cycle_with_inertia * stable_cycle(); });
  } else {
    cycles_per_step_ = &plan.provide_on_run({"cycles in a step of the flow", "N", "-"});
    plan.at_begin([this] { cycles_per_step_->fill(fewest_cycles); });
    plan.add_accuracy_limit("flow beside motion", "16 to 256 cycles of the skeleton",
                            [this] { return (*cycles_per_step_)[0][0] * longest_cycle(); });
  }
  // Nodes that points reach on the way have no pressure before the flow is solved again.
  plan.add_accuracy_limit("motion beside flow", "half a cell", [this] { return cycle_->crossing() / 2; });
  plan.at_record([this](double, meshes::FieldHistory& history) {
    history.counters["cycles in true time"] += static_cast<double>(std::exchange(cycles_, 0));
  });
}

template <int dim>
void TrueTimeMotion<dim>::measure_cells() {
  c_.pore_volume->fill(0);
  // Of cells that points enter before this is measured again; not what a left cell had: a run cut here knows nothing of
  // that.
  for (Cell& cell : cells_) cell.share.fill(1.0 / cell_nodes<dim>);
  each_cell(plan_->fields.points, [this](std::span<const Block* const> blocks) {
    Cell& cell = cells_[blocks.front()->cell];
    cell.share.fill(0);
    double whole = 0;
    for (const Block* block : blocks) {
      const Soil& soil = carried_->soil_of(*block);
      for (std::size_t q = block->first; q < block->first + block->count; ++q) {
        const double v = (*volume_)[0][q], held = carried_->pores(q, soil);
        whole += v;
        for (int i = 0; i < cell_nodes<dim>; ++i) {
          cell.share[i] += v * (*value_)[i][q];
          (*c_.pore_volume)[block->soil][block->nodes[i]] += held * (*value_)[i][q];
        }
      }
    }
    for (double& share : cell.share) share /= whole;
  });
}

template <int dim>
double TrueTimeMotion<dim>::volume_of(const Block& block) const {
  double volume = 0;
  for (std::size_t q = block.first; q < block.first + block.count; ++q) volume += (*volume_)[0][q];
  return volume;
}

template <int dim>
void TrueTimeMotion<dim>::ready() {
  std::ranges::copy(c_.pressure->values(), water_->trial->values().begin());
  refresh_geometry();
  press_points(*c_.pressure);
}

template <int dim>
void TrueTimeMotion<dim>::begin_stage() {
  if (fresh_) carried_->begin();
  if (relative_) relative_->begin(*water_);
  weigh_points();
}

template <int dim>
void TrueTimeMotion<dim>::weigh_points() {
  const double density = plan_->problem.water->density;
  for (const Block& block : plan_->fields.points.blocks())
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      const double mass = (*grains_)[0][q] + density * (*water_of_points_)[0][q], gained = mass - (*mass_)[0][q];
      const Vector<dim> v = at<dim>(*velocity_, q);
      const double fallen = dot<dim>(plan_->problem.gravity, at<dim>(*position_, q));
      (*brought_)[0][0] += gained * (0.5 * dot<dim>(v, v) - fallen);
      for (int a = 0; a < dim; ++a) (*brought_)[1 + a][0] += gained * v[a];
      (*mass_)[0][q] = mass;
    }
}

/// h/c over the cells, c^2 = (E_oed + what the water adds)/density: full pores add (K_l/n), others what their curve
/// lets them. Soils of a cell are strained alike, so their stiffnesses act side by side. [s]
template <int dim>
double TrueTimeMotion<dim>::stable_cycle() const {
  double shortest = std::numeric_limits<double>::infinity();
  each_cell(plan_->fields.points, [&](std::span<const Block* const> blocks) {
    const Block& any = *blocks.front();
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < cell_nodes<dim>; ++i) most = std::max(most, (*c_.pressure)[0][any.nodes[i]]);
    double whole = 0, weight = 0, modulus = 0, room = 0;
    for (const Block* block : blocks) {
      const SoilContent& content = carried_->content_of(*block);
      const Soil& soil = carried_->soil_of(*block);
      double volume = 0, pores = 0, mass = 0;
      for (std::size_t q = block->first; q < block->first + block->count; ++q) {
        volume += (*volume_)[0][q];
        pores += carried_->pores(q, soil);
        mass += (*mass_)[0][q];
      }
      whole += volume;
      weight += mass;
      modulus += (LinearElastic(*soil.elastic).constrained_modulus() - modulus) * (volume / whole);  // mean by volume
      room += pores * std::max(content.at(most + nearly_full).slope, content.at(1.0).slope);
    }
    const double h = plan_->fields.grid.smallest_altitude(any.cell);
    shortest = std::min(shortest, h * std::sqrt(weight / (whole * (modulus + whole / room))));
  });
  return std::min(shortest, cycle_->stable_step());
}

template <int dim>
double TrueTimeMotion<dim>::longest_cycle() const {
  return plan_->stage.step_safety * stable_cycle();
}

/// f_i += V chi p grad N_i with the mean gradient of the cell and its mean pore stress, the adjoint of the volume that
/// answer() sees. A soil takes its share V of the cell and its own chi.
template <int dim>
void TrueTimeMotion<dim>::add_pore_force() {
  const auto blocks = plan_->fields.points.blocks();
  block_volume_.resize(blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    const Cell& cell = cells_[block.cell];
    const SoilContent& content = carried_->content_of(block);
    const double volume = volume_of(block);
    double push = 0, known = 0;
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      const auto node = static_cast<std::size_t>(block.nodes[i]);
      if (!(answer_->room(node) > 0)) continue;  // reached since the flow was last solved
      known += cell.share[i];
      push += cell.share[i] * content.pore_stress((*c_.pressure)[0][node]).value;
    }
    block_volume_[b] = volume;
    if (!(known > 0)) continue;
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a) (*force_)[a][block.nodes[i]] += volume * push / known * cell.slope[i][a];
  }
}

/// What the pores of the nodes have grown by since the blocks' volumes were taken.
template <int dim>
void TrueTimeMotion<dim>::add_growth() {
  const auto blocks = plan_->fields.points.blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Block& block = blocks[b];
    const double growth = volume_of(block) - block_volume_[b];
    for (int i = 0; i < cell_nodes<dim>; ++i)
      answer_->grow(block.soil, block.nodes[i], cells_[block.cell].share[i] * growth);
  }
}

template <int dim>
void TrueTimeMotion<dim>::move_undrained() {
  Clock& clock = plan_->clock;
  const Clock whole = clock;
  answer_->begin(*c_.pore_volume);
  for (double time = whole.time; time < whole.end;) {
    const double rest = whole.end - time, parts = std::ceil(rest / longest_cycle() * (1 - 1e-9));
    clock.time = time;
    clock.end = time = parts > 1 ? time + rest / parts : whole.end;
    clock.dt = cycle_->dt = clock.end - clock.time;
    if (clock.time == whole.time && relative_ && relative_->owes()) pay_reaction();
    for (Kernel* kernel : {cycle_->gather, cycle_->accelerate, cycle_->points, cycle_->velocity, cycle_->move})
      kernel->run();
    add_growth();
    answer_->take((*c_.pressure)[0]);
    cycle_->migrate->run();
    ++cycles_;
  }
  clock = whole;
}

/// The displacement that the water's reaction left to the skeleton. The pressure answers to it after the cycle.
template <int dim>
void TrueTimeMotion<dim>::pay_reaction() {
  cycle_->gather->run();  // who is where
  const auto blocks = plan_->fields.points.blocks();
  block_volume_.resize(blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) block_volume_[b] = volume_of(blocks[b]);
  relative_->pay(cycle_->dt);
  cycle_->move->run();
  add_growth();
  cycle_->migrate->run();
}

/// How many cycles the next step of the flow takes, by the undrained answer to this one's.
template <int dim>
void TrueTimeMotion<dim>::choose_cycles() {
  if (cycles_per_step_ == nullptr) return;
  double most = 0;
  for (const double change : start_) most = std::max(most, std::abs(change));
  double& cycles = (*cycles_per_step_)[0][0];
  cycles = std::clamp(cycles * std::clamp(small_answer / most, 0.5, 2.0), fewest_cycles, most_cycles);
}

template <int dim>
void TrueTimeMotion<dim>::begin_step() {
  carried_->before_motion();
  if (relative_) relative_->before_motion();
  start_.assign(c_.pressure->values().begin(), c_.pressure->values().end());
  move_undrained();
  for (std::size_t i = 0; i < start_.size(); ++i) {
    const double now = (*c_.pressure)[0][i];
    (*c_.pressure)[0][i] = start_[i];
    start_[i] = now - start_[i];
  }
  choose_cycles();
  refresh_geometry();
  carried_->after_motion(start_);
  if (relative_) relative_->after_motion(plan_->clock.dt);
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
  if (relative_) relative_->react(plan_->clock.dt);
  weigh_points();
  press_points(*c_.pressure);
}

template class TrueTimeMotion<2>;
template class TrueTimeMotion<3>;

}  // namespace wetfront::mpm
