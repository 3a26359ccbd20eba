#include "mpm/grid/active_nodes.h"

#include <bit>

namespace wetfront::mpm {

void ActiveNodes::finish() {
  runs_.clear();
  const std::size_t words = marked_.size();
  // Walks from border to border: of a run of ones, then of a run of zeros.
  const auto next = [&](std::size_t from, bool wanted) {
    for (std::size_t w = from / 64; w < words; ++w) {
      std::uint64_t word = wanted ? marked_[w] : ~marked_[w];
      if (w == from / 64) word &= ~std::uint64_t{0} << (from % 64);
      if (word != 0) return std::min(nodes_, 64 * w + static_cast<std::size_t>(std::countr_zero(word)));
    }
    return nodes_;
  };
  for (std::size_t first = next(0, true); first < nodes_;) {
    const std::size_t last = next(first, false);
    runs_.push_back({first, last});
    first = last < nodes_ ? next(last, true) : nodes_;
  }
}

}  // namespace wetfront::mpm
