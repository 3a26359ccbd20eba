#pragma once

#include "mpm/skeleton/linear_shape.h"

#include <array>

/// Sums over four points of a cell at a time.
namespace wetfront::mpm {

/// Per node of a cell, the sum over its points of quantity * N_i.
template <int dim>
struct NodeSums {
  static constexpr int groups = cell_nodes<dim> / lane_count;
  std::array<Lanes, groups> part{};

  void add(const Lanes& quantity, const std::array<Lanes, cell_nodes<dim>>& shape) {
    for (int g = 0; g < groups; ++g)
      part[g] += sums(quantity * shape[4 * g], quantity * shape[4 * g + 1], quantity * shape[4 * g + 2],
                      quantity * shape[4 * g + 3]);
  }
  void copy_to(double* nodes) const {
    for (int g = 0; g < groups; ++g) store(part[g], nodes + lane_count * g);
  }
};

}  // namespace wetfront::mpm
