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

  [[gnu::always_inline]] void add(const Lanes& quantity, const std::array<Lanes, cell_nodes<dim>>& shape) {
    for (int g = 0; g < groups; ++g)
      part[g] += sums(quantity * shape[4 * g], quantity * shape[4 * g + 1], quantity * shape[4 * g + 2],
                      quantity * shape[4 * g + 3]);
  }
};

/// Numbers of a cell's nodes, four at a time.
template <std::size_t nodes>
[[gnu::always_inline]] inline std::array<Lanes, nodes / lane_count> times(double factor,
                                                                          const std::array<double, nodes>& of) {
  std::array<Lanes, nodes / lane_count> out;
  for (std::size_t g = 0; g < nodes / lane_count; ++g) out[g] = load(&of[lane_count * g]) * factor;
  return out;
}
/// The products of two numbers of each node; with more than four nodes those of every fourth are added up.
template <std::size_t nodes>
[[gnu::always_inline]] inline Lanes product(const std::array<double, nodes>& a,
                                            const std::array<Lanes, nodes / lane_count>& b) {
  Lanes out = load(a.data()) * b[0];
  for (std::size_t g = 1; g < nodes / lane_count; ++g) out += load(&a[lane_count * g]) * b[g];
  return out;
}

}  // namespace wetfront::mpm
