#include "fem_reference/flow_operator.h"

#include "fem_reference/tensor.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wetfront::fem_reference {

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
  inflow_.resize(space.dof_count);
  passing_.resize(space.dof_count);
  drainage_slope_.resize(space.dof_count);
  drained_.resize(boundary.condition_count());
  drive_.resize(points * space.dim);
  conductivity_.resize(points);
  make_pattern();
  set_time(0);
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
  evaluate_storage(head);
  std::fill(inflow_.begin(), inflow_.end(), 0.0);
  std::copy(source_.begin(), source_.end(), inflow_.begin());
  std::fill(passing_.begin(), passing_.end(), 0.0);
  evaluate_flow(head);
  evaluate_drainage(head);
}

void FlowOperator::evaluate_storage(std::span<const double> head) {
  std::fill(water_.begin(), water_.end(), 0.0);
  std::fill(capacity_.begin(), capacity_.end(), 0.0);
  for (const StorageShare& share : space_.storage) {
    const ValueAndSlope w = laws_[share.soil].storage(head[share.dof]);
    const double fraction = share.volume / volume_[share.dof];
    water_[share.dof] += fraction * w.value;
    capacity_[share.dof] += fraction * w.slope;
  }
}

void FlowOperator::evaluate_flow(std::span<const double> head) {
  const int n = space_.dofs_per_cell, dim = space_.dim;
  const double* gradient = space_.gradient.data();
  std::size_t point = 0;
  for (int cell = 0; cell < space_.cell_count; ++cell) {
    const int* dof = &space_.cell_dofs[static_cast<std::size_t>(cell) * n];
    const int soil = space_.cell_soil[cell];
    const SoilLaw& law = laws_[soil];
    const double factor = factor_.empty() ? 1 : factor_[space_.mesh_cell[cell]];
    const double* shape = space_.shape_of(cell);
    for (int q = 0; q < space_.points_per_cell; ++q, ++point, shape += n, gradient += n * dim) {
      double* drive = &drive_[point * dim];
      double psi = 0;
      for (int axis = 0; axis < dim; ++axis) drive[axis] = -gravity_[axis];
      for (int a = 0; a < n; ++a) {
        const double value = head[dof[a]];
        psi += shape[a] * value;
        for (int axis = 0; axis < dim; ++axis) drive[axis] += gradient[a * dim + axis] * value;
      }
      if (!isotropic_[soil]) turn(soil, drive);
      const ValueAndSlope k = law.conductivity(psi);
      conductivity_[point] = {factor * k.value, factor * k.slope};
      const double wk = space_.weight[point] * conductivity_[point].value;
      for (int a = 0; a < n; ++a) {
        double along = 0;
        for (int axis = 0; axis < dim; ++axis) along += gradient[a * dim + axis] * drive[axis];
        inflow_[dof[a]] -= wk * along;
        passing_[dof[a]] += std::abs(wk * along);
      }
    }
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
    const double* shape = space_.shape_of(cell);
    for (int q = 0; q < space_.points_per_cell; ++q, ++point, shape += n, gradient += n * dim) {
      const double* drive = &drive_[point * dim];
      const double wk = tau * space_.weight[point] * conductivity_[point].value;
      const double wk_slope = tau * space_.weight[point] * conductivity_[point].slope;
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
          matrix.value[entry[a * n + b]] += wk_slope * shape[b] * along + wk * diffusion;
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
    for (int a = 0; a < n; ++a) rows[dof[a]].insert(rows[dof[a]].end(), dof, dof + n);
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
  pattern_.value.assign(pattern_.column.size(), 0);
  for (int cell = 0; cell < space_.cell_count; ++cell) {
    const int* dof = &space_.cell_dofs[static_cast<std::size_t>(cell) * n];
    for (int a = 0; a < n; ++a) {
      const auto& row = rows[dof[a]];
      for (int b = 0; b < n; ++b) {
        entry_.push_back(pattern_.row_start[dof[a]] +
                         static_cast<int>(std::lower_bound(row.begin(), row.end(), dof[b]) - row.begin()));
      }
    }
  }
}

std::vector<double> FlowOperator::water_at(std::span<const double> head) const {
  std::vector<double> water(space_.dof_count, 0.0);
  for (const StorageShare& share : space_.storage) {
    water[share.dof] += share.volume / volume_[share.dof] * laws_[share.soil].storage(head[share.dof]).value;
  }
  return water;
}

double FlowOperator::stored(std::span<const double> water) const {
  double sum = 0;
  for (int i = 0; i < space_.dof_count; ++i) sum += volume_[i] * water[i];
  return sum;
}

}  // namespace wetfront::fem_reference
