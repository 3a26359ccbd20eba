#pragma once

#include "mpm/two_velocity/cut_surface.h"

#include <vector>

namespace wetfront::mpm {

/// What the impermeable part of the boundary of the occupied cells forbids at its nodes: relative velocity along some
/// directions.
///
/// The faces at a node are grouped by direction (within 45 degrees of each other); each group forbids the direction of
/// its integral of N_i n, so that not even a kinked wall lets water through in the sum, while water may still run along
/// it. Faces of rain sides are left out: they are no walls.
template <int dim>
class ImpermeableWalls {
 public:
  /// `surface`: where cells are cut; then a face is a wall only where soil touches the border of the mesh.
  explicit ImpermeableWalls(const StagePlan<dim>& plan, const CutSurface<dim>* surface = nullptr);

  /// Removes the forbidden directions from a vector at a node.
  void project(std::size_t node, Vector<dim>& v) const {
    for (int k = start_[node]; k < start_[node + 1]; ++k) {
      const Vector<dim>& d = directions_[static_cast<std::size_t>(k)];
      double along = 0;
      for (int a = 0; a < dim; ++a) along += v[a] * d[a];
      for (int a = 0; a < dim; ++a) v[a] -= along * d[a];
    }
  }
  /// No direction is left.
  bool closed(std::size_t node) const { return start_[node + 1] - start_[node] == dim; }

 private:
  std::vector<int> start_;               ///< per node, into directions_
  std::vector<Vector<dim>> directions_;  ///< orthonormal at each node
};

}  // namespace wetfront::mpm
