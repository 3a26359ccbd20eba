#include "fem_reference/linear/band_order.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace wetfront::fem_reference {
namespace {

int width(const SparseMatrix& pattern, const std::vector<int>& position) {
  int widest = 0;
  for (int row = 0; row < pattern.size(); ++row) {
    for (int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k) {
      widest = std::max(widest, std::abs(position[pattern.column[k]] - position[row]));
    }
  }
  return widest;
}

class CuthillMcKee {
 public:
  explicit CuthillMcKee(const SparseMatrix& pattern) : pattern_(pattern), place_(pattern.size(), unseen) {}

  BandOrder run() {
    BandOrder order;
    order.position.resize(place_.size());
    int next = 0;
    for (int seed = 0; seed < pattern_.size(); ++seed) {
      if (place_[seed] != unseen) continue;  // parts that are not connected follow one another
      for (int unknown : sweep(far_end(seed))) order.position[unknown] = next++;
    }
    order.width = width(pattern_, order.position);
    return order;
  }

 private:
  static constexpr int unseen = -1;

  int degree(int row) const { return pattern_.row_start[row + 1] - pattern_.row_start[row]; }

  /// Everything connected to `first`, breadth first; place_ holds the distances, depth_ the largest.
  std::vector<int> sweep(int first) {
    std::vector<int> found{first};
    place_[first] = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const int row = found[i];
      const std::size_t before = found.size();
      for (int k = pattern_.row_start[row]; k < pattern_.row_start[row + 1]; ++k) {
        const int other = pattern_.column[k];
        if (place_[other] != unseen) continue;
        place_[other] = place_[row] + 1;
        found.push_back(other);
      }
      std::sort(found.begin() + before, found.end(), [&](int a, int b) { return degree(a) < degree(b); });
    }
    depth_ = place_[found.back()];
    return found;
  }

  void forget(const std::vector<int>& found) {
    for (int unknown : found) place_[unknown] = unseen;
  }

  /// Goes to the far end of the mesh, and to the far end seen from there, as long as that makes it longer.
  int far_end(int seed) {
    int end = seed;
    for (int deepest = -1;;) {
      const std::vector<int> found = sweep(end);
      int far = found.back();
      for (int unknown : found) {
        if (place_[unknown] == depth_ && degree(unknown) < degree(far)) far = unknown;
      }
      forget(found);
      if (depth_ <= deepest) return end;
      deepest = depth_;
      end = far;
    }
  }

  const SparseMatrix& pattern_;
  std::vector<int> place_;
  int depth_ = 0;
};

}  // namespace

BandOrder narrow_band(const SparseMatrix& pattern) {
  BandOrder given;
  given.position.resize(pattern.size());
  std::iota(given.position.begin(), given.position.end(), 0);
  given.width = width(pattern, given.position);
  BandOrder found = CuthillMcKee(pattern).run();
  return found.width < given.width ? found : given;
}

}  // namespace wetfront::fem_reference
