#pragma once

#include "verification/suites/mechanics/motion.h"

#include <array>
#include <vector>

namespace wetfront::verification {

/// An elastic block 1 m high that lies on a base of 30 degrees with Coulomb friction, on a mesh along the base with
/// gravity turned, or on a mesh that is itself turned, with gravity down: the same problem in other axes.
struct InclineBlock {
  static constexpr double slope = 0.52359877559829887308, gravity = 9.81, density = 2000, young = 5e6, poisson = 0.2,
                          height = 1;
  double friction;  ///< of the base
  bool turned_mesh;
  double end = 2;        ///< s
  double length = 1;     ///< m
  double cell = 0.25;    ///< m
  bool settled = false;  ///< a quasi-static stage of a second first: it begins in equilibrium; else with a K_0 stress
};

template <int dim>
mpm::Problem<dim> block_problem(const InclineBlock& block);

struct BlockState {
  double time;                            ///< s
  std::array<double, 2> place, velocity;  ///< means, along the slope and out of the base
};
template <int dim>
std::vector<BlockState> block_path(const Motion<dim>& motion, const InclineBlock& block);

/// Least squares of the velocity along the slope from entry `first` on: the block rocks about its mean.
double mean_acceleration(const std::vector<BlockState>& path, std::size_t first);

}  // namespace wetfront::verification
