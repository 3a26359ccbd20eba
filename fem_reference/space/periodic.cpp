#include "fem_reference/space/periodic.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wetfront::fem_reference {

PeriodicGroups::PeriodicGroups(int dof_count, int dim) : dim_(dim), same_(dof_count) {
  std::iota(same_.begin(), same_.end(), 0);
}

int PeriodicGroups::root(int dof) const {
  while (same_[dof] != dof) dof = same_[dof];
  return dof;
}

void PeriodicGroups::pair(const PeriodicSides& sides, const std::vector<int>& side, const std::vector<int>& partner,
                          const std::vector<meshes::Point>& position) {
  const auto fail = [&](const char* why) {
    throw std::invalid_argument("periodic sides '" + sides.side + "' and '" + sides.partner + "': " + why);
  };
  if (side.size() != partner.size()) fail("not the same number of nodes");
  meshes::Point shift{};
  for (std::size_t i = 0; i < side.size(); ++i) {
    for (int axis = 0; axis < dim_; ++axis) {
      shift[axis] += (position[partner[i]][axis] - position[side[i]][axis]) / side.size();
    }
  }
  double size = 0;
  for (int axis = 0; axis < dim_; ++axis) size += std::abs(shift[axis]);
  for (int a : side) {
    const auto found = std::find_if(partner.begin(), partner.end(), [&](int b) {
      double distance = 0;
      for (int axis = 0; axis < dim_; ++axis) {
        distance += std::abs(position[b][axis] - position[a][axis] - shift[axis]);
      }
      return distance < 1e-8 * size;  // nodes of a mesh file carry 8 to 16 digits
    });
    if (found == partner.end()) fail("the nodes of one are not those of the other moved by one vector");
    const int low = std::min(root(a), root(*found)), high = std::max(root(a), root(*found));
    same_[high] = low;
  }
}

std::vector<int> PeriodicGroups::numbers() const {
  std::vector<int> number(same_.size(), -1);
  int count = 0;
  for (std::size_t i = 0; i < same_.size(); ++i) {
    const int first = root(static_cast<int>(i));
    number[i] = first == static_cast<int>(i) ? count++ : number[first];
  }
  return number;
}

}  // namespace wetfront::fem_reference
