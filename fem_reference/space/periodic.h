#pragma once

#include "fem_reference/richards_problem.h"

#include <vector>

namespace wetfront::fem_reference {

/// Unknowns that periodic sides share: every dof belongs to the group of its lowest-numbered member.
class PeriodicGroups {
 public:
  PeriodicGroups(int dof_count, int dim);

  /// Pairs the dofs of two sides by place. Throws std::invalid_argument when one side is not the other moved by one
  /// vector.
  void pair(const PeriodicSides& sides, const std::vector<int>& side, const std::vector<int>& partner,
            const std::vector<meshes::Point>& position);
  /// New number of each dof, its group's, without gaps and in the old order.
  std::vector<int> numbers() const;

 private:
  int root(int dof) const;

  int dim_;
  std::vector<int> same_;  ///< a dof of the same group with a lower number, or the dof itself
};

}  // namespace wetfront::fem_reference
