#include "mpm/boundary/contact_gaps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::mpm {

template <int dim>
ContactGaps<dim>::ContactGaps(const StagePlan<dim>& plan)
    : plan_(plan),
      half_spacing_(0.5 / std::round(std::pow(plan.problem.points_per_cell, 1.0 / dim))),
      planes_of_(plan.fields.grid.node_count()) {}

template <int dim>
void ContactGaps<dim>::add_plane(std::size_t node, const Vector<dim>& normal) {
  Range& planes = planes_of_[node];
  if (planes.count == 0) planes.first = normal_.size();
  ++planes.count;
  normal_.push_back(normal);
  gap_.push_back(0);
}

/// Gap between the block's points and the plane through `foot`; may be negative.
template <int dim>
double ContactGaps<dim>::lowest(const Block& block, const Vector<dim>& foot, const Vector<dim>& normal) const {
  const auto& grid = plan_.fields.grid;
  double low = std::numeric_limits<double>::max(), high = -low;
  for (int i = 0; i < cell_nodes<dim>; ++i) {
    const double level = dot<dim>(grid.node(block.nodes[i]), normal);
    low = std::min(low, level);
    high = std::max(high, level);
  }
  double farthest_out = -std::numeric_limits<double>::max();  // along the normal, which points into the base
  for (std::size_t p = block.first; p < block.first + block.count; ++p)
    farthest_out = std::max(farthest_out, dot<dim>(plan_.fields.points.position(p), normal));
  return dot<dim>(foot, normal) - farthest_out - half_spacing_ * (high - low);
}

template <int dim>
void ContactGaps<dim>::finish() {
  const auto& grid = plan_.fields.grid;
  touches_.assign(grid.cell_count(), 0);
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell)
    for (int i = 0; i < cell_nodes<dim>; ++i)
      if (planes_of_[static_cast<std::size_t>(grid.cell_nodes_of(cell)[i])].count > 0) touches_[cell] = 1;
}

template <int dim>
void ContactGaps<dim>::find() {
  const auto& grid = plan_.fields.grid;
  std::fill(gap_.begin(), gap_.end(), std::numeric_limits<double>::max());
  for (const Block& block : plan_.fields.points.blocks()) {
    if (touches_[block.cell] == 0) continue;
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      const Range& planes = planes_of_[static_cast<std::size_t>(block.nodes[i])];
      for (std::size_t k = planes.first; k < planes.first + planes.count; ++k)
        gap_[k] = std::min(gap_[k], lowest(block, grid.node(block.nodes[i]), normal_[k]));
    }
  }
  for (double& gap : gap_) gap = std::max(gap, 0.0);
}

template class ContactGaps<2>;
template class ContactGaps<3>;

}  // namespace wetfront::mpm
