#pragma once

#include "mpm/plan/stage_plan.h"

#include <vector>

namespace wetfront::mpm {

/// How far a body is from the rigid planes of its base.
///
/// The gap at a plane of node i is the distance from the plane of the lowest point in the cells around the node, less
/// half the spacing that points had when the cells were seeded (what of the body lies below its lowest points):
///
///     gap_k = max(min_p (x_i - x_p).n_k - h_n/(2 n), 0),
///
/// h_n the cell's extent along n_k, n points per axis. Found anew from the positions: it is no state.
template <int dim>
class ContactGaps {
 public:
  explicit ContactGaps(const StagePlan<dim>& plan);
  /// A plane through a node; they are numbered in the order in which they come, those of a node together.
  void add_plane(std::size_t node, const Vector<dim>& normal);
  void finish();  ///< no more planes
  void find();
  /// Gap of each plane [m].
  const std::vector<double>& gaps() const { return gap_; }

 private:
  struct Range {
    std::size_t first = 0, count = 0;
  };
  double lowest(const Block& block, const Vector<dim>& foot, const Vector<dim>& normal) const;

  const StagePlan<dim>& plan_;
  double half_spacing_;           ///< over the cell's extent [-]
  std::vector<char> touches_;     ///< per cell: it has a node with planes
  std::vector<Range> planes_of_;  ///< per node of the grid
  std::vector<Vector<dim>> normal_;
  std::vector<double> gap_;
};

}  // namespace wetfront::mpm
