#include "mpm/coupling/fixed_stress.h"

#include "mpm/coupling/water_pull.h"
#include "mpm/grid/soils_of_cells.h"
#include "mpm/laws/linear_elastic.h"
#include "mpm/skeleton/rigid_skeleton.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wetfront::mpm {

namespace {

/// Passes of one step. Where E_oed is what the pores give way by, one suffices; near sides the error falls by 1 - 2 nu.
constexpr int most_passes = 30;
/// Near failure the skeleton goes on moving in every pass. What flow and skeleton then disagree by is carried into the
/// next step, and whether the skeleton has failed is for the relaxation to say.
constexpr int most_passes_near_failure = 2;

}  // namespace

template <int dim>
void FixedStress<dim>::join_own() {
  StagePlan<dim>& plan = *plan_;
  const std::string volume = dim == 2 ? "m2" : "m3";
  const int soils = static_cast<int>(plan.problem.soils.size());
  const auto in_step = [&](const char* name, const char* symbol, const std::string& unit, int components) {
    return &plan.provide_on_nodes({name, symbol, unit, components, Lifetime::step});
  };
  volume_before_ = &plan.provide_on_points({"volume before", "V'", volume});
  pores_before_ = in_step("pores before", "P'", volume, soils);
  compliance_ = in_step("pore compliance", "B", volume + "/Pa", soils);
  base_ = in_step("pore stress met", "g", "Pa", soils);
  stabilisation_ = in_step("stabilisation", "Z", volume, 1);
  mixed_ = in_step("mixing of the passes", "E", volume, 1);
  unsettled_ = &plan.provide_on_nodes({"unsettled water", "M", volume});
  displacement_ = &plan.require_on_nodes("displacement");
  carried_ = std::make_unique<CarriedWater<dim>>(plan, c_, *water_->trial, *contents_);
  cycle_->conditions.push_back(std::make_unique<WaterPull<dim>>(plan));
  relaxer_ = std::make_unique<Relaxer<dim>>(plan, cycle_);
  water_->settle = [this](int pass) { return settle(pass); };
  plan.at_record([this](double, meshes::FieldHistory& history) {
    counts_.tell(history);
    history.counters["passes of the split"] += static_cast<double>(std::exchange(passes_, 0));
    if (plan_->stage.ends_with == StageEnd::failure)
      history.counters["steps left unsettled near failure"] += static_cast<double>(std::exchange(left_, 0));
  });
}

template <int dim>
void FixedStress<dim>::add_storage(int region, const SoilContent& content) const {
  const double *pores = (*c_.pore_volume)[region], *b = (*compliance_)[region], *base = (*base_)[region];
  const double* p = (*water_->trial)[0];
  double *stored = (*water_->stored)[0], *capacity = (*water_->capacity)[0];
  for (std::size_t i = 0; i < c_.pressure->size(); ++i) {
    if (!(pores[i] > 0)) continue;
    const ValueAndSlope held = content.at(p[i]), push = content.pore_stress(p[i]);
    const double room = pores[i] + b[i] * (push.value - base[i]);
    stored[i] += room * held.value;
    capacity[i] += room * held.slope + b[i] * push.slope * held.value;
  }
}

template <int dim>
void FixedStress<dim>::add_offsets() const {
  const double *z = (*stabilisation_)[0], *mixed = (*mixed_)[0];
  double* stored = (*water_->stored)[0];
  for (std::size_t i = 0; i < stabilisation_->size(); ++i) stored[i] += z[i] + mixed[i];
}

/// Sums over the points of a block, also to the nodes; `slope` takes V grad N_j of each, `share` V N_i.
template <int dim>
typename FixedStress<dim>::Cell FixedStress<dim>::measure(const Block& block,
                                                          std::array<Vector<dim>, cell_nodes<dim>>& slope) const {
  const Column &volume = *this->volume_, &value = *this->value_, &gradient = *this->gradient_;
  constexpr int n = cell_nodes<dim>;
  Cell cell;
  cell.cell = block.cell;
  cell.nodes = block.nodes;
  cell.region = block.soil;
  const Soil& soil = carried_->soil_of(block);
  cell.stiffness = LinearElastic(*soil.elastic).constrained_modulus();
  for (std::size_t q = block.first; q < block.first + block.count; ++q) {
    const double v = volume[0][q], grains = v - carried_->pores(q, soil);
    cell.volume += v;
    for (int i = 0; i < n; ++i) {
      const double part = value[i][q];
      cell.share[i] += v * part;
      (*c_.pore_volume)[cell.region][block.nodes[i]] += part * (v - grains);
      (*pores_before_)[cell.region][block.nodes[i]] += part * ((*volume_before_)[0][q] - grains);
      (*compliance_)[cell.region][block.nodes[i]] += part * v / cell.stiffness;
      for (int a = 0; a < dim; ++a) slope[i][a] += v * gradient[i * dim + a][q];
      for (int j = 0; j < n; ++j)
        for (int a = 0; a < dim; ++a) cell.strain[i][j][a] += part * v * gradient[j * dim + a][q];
    }
  }
  return cell;
}

template <int dim>
void FixedStress<dim>::measure_cells() {
  const bool averaged = plan_->problem.skeleton.locking == LockingRemedy::b_bar;
  constexpr int n = cell_nodes<dim>;
  cells_.clear();
  for (Column* column : {c_.pore_volume, pores_before_, compliance_}) column->fill(0);
  each_cell(plan_->fields.points, [&](std::span<const Block* const> blocks) {
    std::array<Vector<dim>, n> slope{};
    std::array<double, n> share{};
    double whole = 0;
    const std::size_t first = cells_.size();
    for (const Block* block : blocks) cells_.push_back(measure(*block, slope));
    const std::span<Cell> here(cells_.begin() + static_cast<std::ptrdiff_t>(first), cells_.end());
    for (const Cell& cell : here) {
      whole += cell.volume;
      for (int i = 0; i < n; ++i) share[i] += cell.share[i];
    }
    for (Cell& cell : here) {
      for (int i = 0; i < n; ++i) {
        const double own = cell.share[i] / whole;
        cell.share[i] = share[i] / whole;
        for (int j = 0; j < n && averaged; ++j)
          for (int a = 0; a < dim; ++a) cell.strain[i][j][a] = own * slope[j][a];
      }
    }
  });
}

template <int dim>
void FixedStress<dim>::ready() {
  std::ranges::copy(c_.pressure->values(), water_->trial->values().begin());
  std::ranges::copy(this->volume_->values(), volume_before_->values().begin());
  refresh_geometry();
  rebase();
}

/// The skeleton comes to rest under its weight and the first pressures with the pressures kept (drained), so that the
/// first step holds nothing but what happens in it. A load that jumps at the beginning is not there yet.
template <int dim>
void FixedStress<dim>::begin_stage() {
  if (!fresh_) return;
  plan_->clock.end = plan_->begin_time();
  carried_->begin();
  // Twice: pores that have given way hold less water, which weighs less.
  for (int pass = 0; pass < 2; ++pass) {
    press_points(*water_->trial);
    relaxer_->begin_step();
    counts_.add(relaxer_->run());
    ready();
    carried_->begin();
  }
}

/// g of the pressures met so far, and the water of p^n in the pores of the beginning of the step, at present places.
template <int dim>
void FixedStress<dim>::rebase() {
  const std::size_t nodes = c_.pressure->size();
  for (std::size_t i = 0; i < nodes; ++i) {
    double held = (*unsettled_)[0][i];
    for (std::size_t r = 0; r < contents_->size(); ++r) {
      const int region = static_cast<int>(r);
      (*base_)[region][i] = (*contents_)[r].pore_stress((*water_->trial)[0][i]).value;
      held += (*pores_before_)[region][i] * (*contents_)[r].at((*c_.pressure)[0][i]).value;
    }
    if (history_.size() == nodes) {
      (*c_.stored)[0][i] = held;
      (*c_.stored_before)[0][i] = held - history_[i];
    }
  }
}

template <int dim>
void FixedStress<dim>::begin_step() {
  const auto stored = c_.stored->values(), before = c_.stored_before->values();
  history_.resize(stored.size());
  for (std::size_t i = 0; i < stored.size(); ++i) history_[i] = stored[i] - before[i];
  std::ranges::copy(this->volume_->values(), volume_before_->values().begin());
  std::ranges::copy(c_.pressure->values(), water_->trial->values().begin());
  stabilisation_->fill(0);
  mixed_->fill(0);
  refresh_geometry();
  rebase();
  relaxer_->begin_step();
}

/// Z_i = sum_c S V_c/E_oed w_i (dg_i - sum_j w_j dg_j): what nodes would hold if they gave way by their own pressure
/// and not by the mean of the cell. Sums to zero over every cell.
template <int dim>
void FixedStress<dim>::find_stabilisation() {
  stabilisation_->fill(0);
  for (const Cell& cell : cells_) {
    const SoilContent& content = (*contents_)[static_cast<std::size_t>(cell.region)];
    std::array<double, cell_nodes<dim>> change{};
    double mean = 0, held = 0;
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      const double now = (*water_->trial)[0][cell.nodes[i]], before = (*c_.pressure)[0][cell.nodes[i]];
      change[i] = content.pore_stress(now).value - content.pore_stress(before).value;
      mean += cell.share[i] * change[i];
      held += cell.share[i] * content.at(now).value;
    }
    const double scale = held * cell.volume / cell.stiffness;
    for (int i = 0; i < cell_nodes<dim>; ++i)
      (*stabilisation_)[0][cell.nodes[i]] += scale * cell.share[i] * (change[i] - mean);
  }
}

/// Water that the last solve foresaw in the pores, less what fits into those found.
template <int dim>
void FixedStress<dim>::find_foreseen() {
  const std::size_t nodes = c_.pressure->size();
  const double* trial = (*water_->trial)[0];
  off_.assign(mixed_->values().begin(), mixed_->values().end());
  for (std::size_t r = 0; r < contents_->size(); ++r) {
    const int region = static_cast<int>(r);
    const SoilContent& content = (*contents_)[r];
    for (std::size_t i = 0; i < nodes; ++i)
      off_[i] += (*compliance_)[region][i] * (content.pore_stress(trial[i]).value - (*base_)[region][i]) *
                 content.at(trial[i]).value;
  }
  const auto moved = displacement_->values();
  for (const Cell& cell : cells_)
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      double found = 0;
      for (int j = 0; j < cell_nodes<dim>; ++j)
        for (int a = 0; a < dim; ++a) {
          const auto at = static_cast<std::size_t>(a) * nodes + static_cast<std::size_t>(cell.nodes[j]);
          found += cell.strain[i][j][a] * (moved[at] - displaced_[at]);
        }
      off_[static_cast<std::size_t>(cell.nodes[i])] -=
          found * (*contents_)[static_cast<std::size_t>(cell.region)].at(trial[cell.nodes[i]]).value;
    }
  stabilised_.assign(stabilisation_->values().begin(), stabilisation_->values().end());
  find_stabilisation();
  for (std::size_t i = 0; i < nodes; ++i) off_[i] += stabilised_[i] - (*stabilisation_)[0][i];
}

/// After a solve: relaxes the skeleton and says whether the flow has to be solved again.
template <int dim>
bool FixedStress<dim>::settle(int pass) {
  press_points(*water_->trial);
  carried_->before_motion();
  displaced_.assign(displacement_->values().begin(), displacement_->values().end());
  const auto rest = relaxer_->run();
  counts_.add(rest);
  ++passes_;
  find_foreseen();
  // As pressures: what is off divided by what a node takes up per pascal.
  const std::size_t nodes = c_.pressure->size();
  weight_.assign(nodes, 0.0);
  double size = 0, whole = 0, error = 0;
  for (std::size_t i = 0; i < nodes; ++i) {
    double pores = 0;
    for (std::size_t r = 0; r < contents_->size(); ++r) pores += (*c_.pore_volume)[static_cast<int>(r)][i];
    const double capacity = (*water_->capacity)[0][i], p = (*water_->trial)[0][i];
    if (capacity > 0) weight_[i] = pores / (capacity * capacity);
    size += pores * p * p;
    whole += pores;
  }
  for (const auto& held : water_->held) weight_[static_cast<std::size_t>(held.node)] = 0;
  for (std::size_t i = 0; i < nodes; ++i) error += weight_[i] * off_[i] * off_[i];
  refresh_geometry();
  carried_->after_motion();
  const double change = std::sqrt(error / whole), scale = std::sqrt(size / whole) + pressure_scale();
  // Damped motion ends somewhere within its ratio: finer than that the two cannot agree.
  const bool agreed = change <= std::max(plan_->stage.relaxation.coupling_tolerance, rest.ratio) * scale;
  const bool left = !agreed && plan_->stage.ends_with == StageEnd::failure && pass >= most_passes_near_failure;
  left_ += left;
  if (agreed || left) {
    // What the step gained is told in the pores of its last solve: they stay as they were there.
    std::ranges::copy(off_, unsettled_->values().begin());
    return false;
  }
  rebase();
  if (pass >= most_passes)
    throw StepFailed(
        "flow and skeleton do not agree after " + std::to_string(most_passes) + " passes: pressures still change by " +
        std::to_string(change) + " Pa, and the skeleton moved " + std::to_string(rest.displacement) +
        " m in the last one (near failure it does not stop). Use a larger coupling_tolerance, or go on with "
        "a dynamic stage");
  if (pass == 0) anderson_.clear();
  for (double& off : off_) off = -off;
  const std::vector<double> more = anderson_.mix(off_, weight_);
  std::ranges::copy(more, mixed_->values().begin());
  return true;
}

template <int dim>
double FixedStress<dim>::pressure_scale() const {
  double scale = 1e300;
  for (const SoilContent& content : *contents_) scale = std::min(scale, content.curve().pressure_scale());
  return scale;
}

template class FixedStress<2>;
template class FixedStress<3>;

}  // namespace wetfront::mpm
