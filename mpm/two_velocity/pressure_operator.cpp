#include "mpm/two_velocity/pressure_operator.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace wetfront::mpm {

template <int dim>
PressureOperator<dim>::PressureOperator(const StagePlan<dim>& plan, const TwoVelocityWater<dim>& water)
    : plan_(plan), water_(water) {
  const auto& points = plan.fields.points;
  const Column &shape = *points.columns.find("shape value"), &volume = *points.columns.find("volume");
  for (const Block& block : points.blocks()) {
    auto& m = mass_.emplace_back();
    for (std::size_t q = block.first; q < block.first + block.count; ++q)
      for (int i = 0; i < cell_nodes<dim>; ++i)
        for (int j = 0; j < cell_nodes<dim>; ++j) m[i][j] += volume[0][q] * shape[i][q] * shape[j][q];
  }
  for (auto* list : {&node_, &mapped_, &sum_}) list->resize(plan.fields.grid.node_count());
  outflow_.resize(mass_.size());
}

/// A_cc, a disturbed cell alone, with or without mapping.
template <int dim>
void PressureOperator<dim>::scale_by(Scale scale) {
  diagonal_.clear();
  const auto blocks = plan_.fields.points.blocks();
  std::map<std::pair<int, int>, double> mass;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int j = 0; j < cell_nodes<dim>; ++j) mass[{blocks[b].nodes[i], blocks[b].nodes[j]}] += mass_[b][i][j];
  for (const Block& block : blocks) {
    auto in = water_.cells.gradient[block.cell], out = water_.cells.faces[block.cell];
    for (auto* list : {&in, &out})
      for (int i = 0; i < cell_nodes<dim>; ++i) {
        for (double& component : (*list)[i]) component /= (*water_.volume)[0][block.nodes[i]];
        water_.walls.project(static_cast<std::size_t>(block.nodes[i]), (*list)[i]);
      }
    double diagonal = 0;
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int j = 0; j < cell_nodes<dim>; ++j)
        for (int a = 0; a < dim; ++a) {
          const double volume = i == j ? (*water_.volume)[0][block.nodes[i]] : 0.0;
          diagonal +=
              out[i][a] * in[j][a] * (scale == Scale::mapped ? mass.at({block.nodes[i], block.nodes[j]}) : volume);
        }
    diagonal_.push_back(std::max(0.0, diagonal) / water_.cells.volume[block.cell]);
  }
}

/// Nodes to points and back, and to the walls: mapped_ = P M node_, then both hold it.
template <int dim>
void PressureOperator<dim>::map() {
  std::fill(mapped_.begin(), mapped_.end(), Vector<dim>{});
  const auto blocks = plan_.fields.points.blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int j = 0; j < cell_nodes<dim>; ++j)
        for (int a = 0; a < dim; ++a) mapped_[blocks[b].nodes[i]][a] += mass_[b][i][j] * node_[blocks[b].nodes[j]][a];
  for (const auto& [i, normal] : water_.unmapped) {
    double missing = 0;
    for (int a = 0; a < dim; ++a) missing += ((*water_.volume)[0][i] * node_[i][a] - mapped_[i][a]) * normal[a];
    for (int a = 0; a < dim; ++a) mapped_[i][a] += missing * normal[a];
  }
  node_.swap(mapped_);
  project();
}

/// Momentum to velocity, less what the walls forbid.
template <int dim>
void PressureOperator<dim>::project() {
  for (std::size_t i = 0; i < node_.size(); ++i) {
    if (!((*water_.volume)[0][i] > 0)) continue;
    for (double& component : node_[i]) component /= (*water_.volume)[0][i];
    water_.walls.project(i, node_[i]);
  }
}

/// outflow_ = A pressure_.
template <int dim>
void PressureOperator<dim>::apply(Drag drag) {
  const auto blocks = plan_.fields.points.blocks();
  std::fill(node_.begin(), node_.end(), Vector<dim>{});
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a)
        node_[blocks[b].nodes[i]][a] += pressure_[b] * water_.cells.gradient[blocks[b].cell][i][a];
  project();
  // M/(2 - M) = sum of (M/2)^k; the modes that decide have m near 0.6, of which seven terms leave 3e-4.
  const int terms = drag == Drag::none ? 1 : 7;
  double factor = drag == Drag::none ? 1 : 0.5;
  std::fill(sum_.begin(), sum_.end(), Vector<dim>{});
  for (int k = 0; k < terms; ++k, factor *= 0.5) {
    map();
    for (std::size_t i = 0; i < sum_.size(); ++i)
      for (int a = 0; a < dim; ++a) sum_[i][a] += factor * node_[i][a];
  }
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    outflow_[b] = 0;
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a)
        outflow_[b] += water_.cells.faces[blocks[b].cell][i][a] * sum_[blocks[b].nodes[i]][a];
    outflow_[b] /= water_.cells.volume[blocks[b].cell];
  }
}

template <int dim>
std::vector<double> PressureOperator<dim>::bound(Drag drag) {
  const auto blocks = plan_.fields.points.blocks();
  pressure_.assign(diagonal_.size(), 0);
  for (std::size_t b = 0; b < pressure_.size(); ++b) pressure_[b] = std::sin(1 + 12.9898 * static_cast<double>(b));
  double largest = 0;
  // Rayleigh's quotient converges twice as fast as the vector; what is left after a change of 1e-4 is below the
  // hundredth added.
  for (int iteration = 0; iteration < 300; ++iteration) {
    apply(drag);
    double numerator = 0, denominator = 0, size = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const double volume = water_.cells.volume[blocks[b].cell];
      numerator += volume * pressure_[b] * outflow_[b];
      denominator += volume * pressure_[b] * diagonal_[b] * pressure_[b];
      pressure_[b] = diagonal_[b] > 0 ? outflow_[b] / diagonal_[b] : 0;
      size = std::max(size, std::abs(pressure_[b]));
    }
    if (!(size > 0)) break;
    for (double& p : pressure_) p /= size;
    const double now = numerator / denominator;
    const bool settled = std::abs(now - largest) < 1e-4 * now && iteration > 20;
    largest = now;
    if (settled) break;
  }
  std::vector<double> bound(plan_.fields.grid.cell_count());
  for (std::size_t b = 0; b < blocks.size(); ++b) bound[blocks[b].cell] = 1.01 * largest * diagonal_[b];
  return bound;
}

template class PressureOperator<2>;
template class PressureOperator<3>;

}  // namespace wetfront::mpm
