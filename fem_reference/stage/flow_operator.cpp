#include "fem_reference/stage/flow_operator.h"

#include "fem_reference/soil/tensor.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wetfront::fem_reference {
namespace {

// Ratio of the largest to the least K at the points of a cell: up to `gentle` they are taken as they are, from `steep`
// on their mean over the range of heads, in between a blend with continuous slopes.
constexpr double gentle = 10, steep = 100;

}  // namespace

FlowOperator::FlowOperator(const RichardsProblem& problem, const Discretisation& space, const Boundary& boundary)
    : space_(space),
      boundary_(boundary),
      gravity_(problem.gravity_direction),
      source_function_(problem.source),
      factor_(problem.conductivity_factor) {
  for (const Soil& soil : problem.soils) {
    laws_.emplace_back(soil, problem.unit_weight);
    anisotropy_.push_back(soil.anisotropy);
    isotropic_.push_back(soil.anisotropy == isotropic);
  }
  const std::size_t points = static_cast<std::size_t>(space.cell_count) * space.points_per_cell;
  volume_.assign(space.dof_count, 0);
  for (const StorageShare& share : space.storage) volume_[share.dof] += share.volume;
  water_.resize(space.dof_count);
  capacity_.resize(space.dof_count);
  const std::size_t all = space.dof_count + space.ranks.ghosts();  // what falls on a ghost is its owner's to know
  inflow_.resize(all);
  passing_.resize(all);
  drainage_slope_.resize(space.dof_count);
  drained_.resize(boundary.condition_count());
  drive_.resize(points * space.dim);
  conductivity_.resize(points);
  conductivity_slope_.resize(points * space.dofs_per_cell);
  sort_shares();
  make_pattern();
  set_time(0);
}

void FlowOperator::sort_shares() {
  first_share_.assign(space_.dof_count + 1, 0);
  for (const StorageShare& share : space_.storage) ++first_share_[share.dof + 1];
  std::partial_sum(first_share_.begin(), first_share_.end(), first_share_.begin());
  shares_.resize(space_.storage.size());
  std::vector<int> next = first_share_;
  for (const StorageShare& share : space_.storage) {
    shares_[next[share.dof]++] = {share.soil, share.volume / volume_[share.dof]};
  }
}

ValueAndSlope FlowOperator::storage_at(int dof, double head) const {
  ValueAndSlope sum;
  for (int k = first_share_[dof]; k < first_share_[dof + 1]; ++k) {
    const ValueAndSlope w = laws_[shares_[k].first].storage(head);
    sum.value += shares_[k].second * w.value;
    sum.slope += shares_[k].second * w.slope;
  }
  return sum;
}

void FlowOperator::set_time(double time) {
  if (!has_source()) return;
  source_.resize(space_.dof_count);
  for (int i = 0; i < space_.dof_count; ++i) source_[i] = volume_[i] * source_function_(space_.position[i], time);
}

double FlowOperator::source_total() const {
  return std::accumulate(source_.begin(), source_.end(), 0.0);
}

void FlowOperator::evaluate(std::span<const double> head) {
  const CostTimer timer(evaluation_cost);
  head_.assign(head.begin(), head.end());
  head_.resize(inflow_.size());
  space_.ranks.refresh(head_);
  evaluate_storage(head);
  std::fill(inflow_.begin(), inflow_.end(), 0.0);
  std::copy(source_.begin(), source_.end(), inflow_.begin());
  std::fill(passing_.begin(), passing_.end(), 0.0);
  evaluate_flow(head_);
  evaluate_drainage(head);
}

void FlowOperator::evaluate_storage(std::span<const double> head) {
  for (int i = 0; i < space_.dof_count; ++i) {
    const ValueAndSlope w = storage_at(i, head[i]);
    water_[i] = w.value;
    capacity_[i] = w.slope;
  }
}

void FlowOperator::evaluate_flow(std::span<const double> head) {
  const int n = space_.dofs_per_cell, dim = space_.dim;
  const double* gradient = space_.gradient.data();
  std::size_t point = 0;
  for (int cell = 0; cell < space_.cell_count; ++cell) {
    const int* dof = &space_.cell_dofs[static_cast<std::size_t>(cell) * n];
    const int soil = space_.cell_soil[cell];
    evaluate_conductivity(cell, head);
    for (int q = 0; q < space_.points_per_cell; ++q, ++point, gradient += n * dim) {
      double* drive = &drive_[point * dim];
      for (int axis = 0; axis < dim; ++axis) drive[axis] = -gravity_[axis];
      for (int a = 0; a < n; ++a) {
        for (int axis = 0; axis < dim; ++axis) drive[axis] += gradient[a * dim + axis] * head[dof[a]];
      }
      if (!isotropic_[soil]) turn(soil, drive);
      const double wk = space_.weight[point] * conductivity_[point];
      for (int a = 0; a < n; ++a) {
        double along = 0;
        for (int axis = 0; axis < dim; ++axis) along += gradient[a * dim + axis] * drive[axis];
        inflow_[dof[a]] -= wk * along;
        passing_[dof[a]] += std::abs(wk * along);
      }
    }
  }
}

/// K at the points of a cell and its derivatives (README, Eq 3).
void FlowOperator::evaluate_conductivity(int cell, std::span<const double> head) {
  const int n = space_.dofs_per_cell, points = space_.points_per_cell;
  const int* dof = &space_.cell_dofs[static_cast<std::size_t>(cell) * n];
  const SoilLaw& law = laws_[space_.cell_soil[cell]];
  const double factor = factor_.empty() ? 1 : factor_[space_.mesh_cell[cell]];
  const double* shape = space_.shape_of(cell);
  double* value = &conductivity_[static_cast<std::size_t>(cell) * points];
  double* slope = &conductivity_slope_[static_cast<std::size_t>(cell) * points * n];
  int most = 0, least = 0;
  for (int q = 0; q < points; ++q) {
    double psi = 0;
    for (int a = 0; a < n; ++a) psi += shape[q * n + a] * head[dof[a]];
    const ValueAndSlope k = law.conductivity(psi);
    value[q] = factor * k.value;
    for (int a = 0; a < n; ++a) slope[q * n + a] = factor * k.slope * shape[q * n + a];
    if (value[q] > value[most]) most = q;
    if (value[q] < value[least]) least = q;
  }
  if (value[most] > gentle * value[least]) blend_conductivity(cell, head, factor, most, least);
}

// Two points per axis see nothing of a front that is thinner than the cell: both heads are nearly the dry one, K is
// ten decades too small, and a wet node cannot pass its water on. There the mean of K over the range of heads in the
// cell takes over: on a line that is the exact integral of K(psi_h).
void FlowOperator::blend_conductivity(int cell, std::span<const double> head, double factor, int most, int least) {
  const int n = space_.dofs_per_cell, points = space_.points_per_cell;
  const int* dof = &space_.cell_dofs[static_cast<std::size_t>(cell) * n];
  const SoilLaw& law = laws_[space_.cell_soil[cell]];
  double* value = &conductivity_[static_cast<std::size_t>(cell) * points];
  double* slope = &conductivity_slope_[static_cast<std::size_t>(cell) * points * n];
  int wet = 0, dry = 0;
  for (int a = 1; a < n; ++a) {
    if (head[dof[a]] > head[dof[wet]]) wet = a;
    if (head[dof[a]] < head[dof[dry]]) dry = a;
  }
  constexpr double tiny = 1e-280;
  static const double width = std::log(steep / gentle);
  const double high = std::max(tiny, value[most]), low = std::max(tiny, value[least]);
  const double x = std::min(1.0, std::log(high / low / gentle) / width);
  const double share = x * x * (3 - 2 * x), share_slope = 6 * x * (1 - x) / width;
  const double range = head[dof[wet]] - head[dof[dry]];
  const ValueAndSlope upper = law.conductivity_integral(head[dof[wet]]);
  const ValueAndSlope lower = law.conductivity_integral(head[dof[dry]]);
  const double mean = factor * (upper.value - lower.value) / range;
  std::vector<double>& share_by_head = scratch_;
  share_by_head.resize(n);
  for (int a = 0; a < n; ++a) {
    share_by_head[a] = share_slope * (slope[most * n + a] / high - slope[least * n + a] / low);
  }
  for (int q = 0; q < points; ++q) {
    for (int a = 0; a < n; ++a) {
      slope[q * n + a] = (1 - share) * slope[q * n + a] + share_by_head[a] * (mean - value[q]);
    }
    slope[q * n + wet] += share * (factor * upper.slope - mean) / range;
    slope[q * n + dry] += share * (mean - factor * lower.slope) / range;
    value[q] = (1 - share) * value[q] + share * mean;
  }
}

void FlowOperator::turn(int soil, double* vector) const {
  meshes::Point v{};
  std::copy_n(vector, space_.dim, v.begin());
  v = times(anisotropy_[soil], v);
  std::copy_n(v.begin(), space_.dim, vector);
}

void FlowOperator::evaluate_drainage(std::span<const double> head) {
  std::fill(drained_.begin(), drained_.end(), 0.0);
  std::fill(drainage_slope_.begin(), drainage_slope_.end(), 0.0);
  for (const auto& [dof, soil, area, condition] : boundary_.drains()) {
    const ValueAndSlope k = laws_[soil].conductivity(head[dof]);
    inflow_[dof] -= area * k.value;
    drained_[condition] += area * k.value;
    drainage_slope_[dof] += area * k.slope;
  }
}

void FlowOperator::assemble(double tau, SparseMatrix& matrix) const {
  const CostTimer timer(assembly_cost);
  std::fill(matrix.value.begin(), matrix.value.end(), 0.0);
  const int n = space_.dofs_per_cell, dim = space_.dim;
  const double* gradient = space_.gradient.data();
  const int* entry = entry_.data();
  std::vector<double> turned(static_cast<std::size_t>(n) * dim);
  std::size_t point = 0;
  for (int cell = 0; cell < space_.cell_count; ++cell, entry += n * n) {
    const int soil = space_.cell_soil[cell];
    for (int q = 0; q < space_.points_per_cell; ++q, ++point, gradient += n * dim) {
      const double* drive = &drive_[point * dim];
      const double weight = tau * space_.weight[point], wk = weight * conductivity_[point];
      const double* slope = &conductivity_slope_[point * n];
      const double* conjugate = gradient;  // T grad N_b
      if (!isotropic_[soil]) {
        std::copy_n(gradient, n * dim, turned.begin());
        for (int a = 0; a < n; ++a) turn(soil, &turned[a * dim]);
        conjugate = turned.data();
      }
      for (int a = 0; a < n; ++a) {
        double along = 0;
        for (int axis = 0; axis < dim; ++axis) along += gradient[a * dim + axis] * drive[axis];
        for (int b = 0; b < n; ++b) {
          double diffusion = 0;
          for (int axis = 0; axis < dim; ++axis) diffusion += gradient[a * dim + axis] * conjugate[b * dim + axis];
          matrix.value[entry[a * n + b]] += weight * slope[b] * along + wk * diffusion;
        }
      }
    }
  }
  for (int i = 0; i < space_.dof_count; ++i) {
    matrix.value[diagonal_[i]] += volume_[i] * capacity_[i] + tau * drainage_slope_[i];
  }
}

SparseMatrix FlowOperator::pattern() const {
  return pattern_;
}

void FlowOperator::make_pattern() {
  const int n = space_.dofs_per_cell;
  std::vector<std::vector<int>> rows(space_.dof_count);
  for (int cell = 0; cell < space_.cell_count; ++cell) {
    const int* dof = &space_.cell_dofs[static_cast<std::size_t>(cell) * n];
    for (int a = 0; a < n; ++a) {
      if (dof[a] < space_.dof_count) rows[dof[a]].insert(rows[dof[a]].end(), dof, dof + n);
    }
  }
  pattern_.row_start.push_back(0);
  diagonal_.resize(space_.dof_count);
  for (int i = 0; i < space_.dof_count; ++i) {
    std::sort(rows[i].begin(), rows[i].end());
    rows[i].erase(std::unique(rows[i].begin(), rows[i].end()), rows[i].end());
    diagonal_[i] = pattern_.row_start.back() +
                   static_cast<int>(std::lower_bound(rows[i].begin(), rows[i].end(), i) - rows[i].begin());
    pattern_.column.insert(pattern_.column.end(), rows[i].begin(), rows[i].end());
    pattern_.row_start.push_back(static_cast<int>(pattern_.column.size()));
  }
  const int spare = static_cast<int>(pattern_.column.size());  // behind the matrix: takes the rows of ghosts
  pattern_.value.assign(spare + 1, 0);
  for (int cell = 0; cell < space_.cell_count; ++cell) {
    const int* dof = &space_.cell_dofs[static_cast<std::size_t>(cell) * n];
    for (int a = 0; a < n; ++a) {
      if (dof[a] >= space_.dof_count) {
        entry_.insert(entry_.end(), n, spare);
        continue;
      }
      const auto& row = rows[dof[a]];
      for (int b = 0; b < n; ++b) {
        entry_.push_back(pattern_.row_start[dof[a]] +
                         static_cast<int>(std::lower_bound(row.begin(), row.end(), dof[b]) - row.begin()));
      }
    }
  }
}

std::vector<double> FlowOperator::water_at(std::span<const double> head) const {
  std::vector<double> water(space_.dof_count);
  for (int i = 0; i < space_.dof_count; ++i) water[i] = storage_at(i, head[i]).value;
  return water;
}

double FlowOperator::stored(std::span<const double> water) const {
  double sum = 0;
  for (int i = 0; i < space_.dof_count; ++i) sum += volume_[i] * water[i];
  return space_.ranks.sum(sum);
}

}  // namespace wetfront::fem_reference
