#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace wetfront::mpm {

/// Consecutive nodes first .. last-1.
struct NodeRun {
  std::size_t first, last;
};

/// The nodes around occupied cells, ascending, as runs.
class ActiveNodes {
 public:
  explicit ActiveNodes(std::size_t nodes) : marked_((nodes + 63) / 64), nodes_(nodes) { runs_.reserve(64); }

  void clear() { std::fill(marked_.begin(), marked_.end(), 0); }
  void mark(int node) { marked_[static_cast<std::size_t>(node) / 64] |= std::uint64_t{1} << (node % 64); }
  /// Makes the runs of what has been marked.
  void finish();
  const std::vector<NodeRun>& runs() const { return runs_; }

 private:
  std::vector<std::uint64_t> marked_;
  std::vector<NodeRun> runs_;
  std::size_t nodes_;
};

}  // namespace wetfront::mpm
