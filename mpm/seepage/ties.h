#pragma once

#include "mpm/seepage/sparse_system.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace wetfront::mpm {

/// Nodes that are one: `node` has the pressure of `root`, whose balance is the sum of both. (Periodic sides.)
class Ties {
 public:
  struct Pair {
    int node, root;
  };
  std::vector<Pair> pairs;

  /// Adds what the rows of the roots need to take up those of their nodes.
  void add_couplings(std::vector<std::pair<int, int>>& couplings) const {
    std::vector<std::pair<int, int>> more;
    for (const Pair& pair : pairs) {
      more.emplace_back(pair.node, pair.root);
      for (const auto& [row, column] : couplings)
        if (row == pair.node) more.emplace_back(pair.root, column);
      more.emplace_back(pair.root, pair.node);
    }
    couplings.insert(couplings.end(), more.begin(), more.end());
  }
  /// `couplings` are those of the matrix, made with add_couplings.
  void prepare(SparseSystem& matrix, const std::vector<std::pair<int, int>>& couplings) {
    moves_.assign(pairs.size(), {});
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      moves_[k].emplace_back(matrix.slot(pairs[k].node, pairs[k].node), matrix.slot(pairs[k].root, pairs[k].node));
      for (const auto& [row, column] : couplings)
        if (row == pairs[k].node && column != row && column != pairs[k].root)
          moves_[k].emplace_back(matrix.slot(row, column), matrix.slot(pairs[k].root, column));
      std::sort(moves_[k].begin(), moves_[k].end());
      moves_[k].erase(std::unique(moves_[k].begin(), moves_[k].end()), moves_[k].end());
      const int across = matrix.slot(pairs[k].node, pairs[k].root);
      moves_[k].emplace_back(across, matrix.slot(pairs[k].root, pairs[k].root));
    }
  }
  void sum_rows(SparseSystem& matrix) const {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      for (const auto& [from, to] : moves_[k])
        matrix.values()[static_cast<std::size_t>(to)] += matrix.values()[static_cast<std::size_t>(from)];
      matrix.make_identity_row(pairs[k].node);
      matrix.values()[static_cast<std::size_t>(matrix.slot(pairs[k].node, pairs[k].root))] = -1;
    }
  }
  void sum_balance(std::vector<double>& balance) const {
    for (const Pair& pair : pairs)
      balance[static_cast<std::size_t>(pair.root)] += std::exchange(balance[static_cast<std::size_t>(pair.node)], 0.0);
  }
  void copy_pressure(double* pressure) const {
    for (const Pair& pair : pairs) pressure[pair.node] = pressure[pair.root];
  }

 private:
  std::vector<std::vector<std::pair<int, int>>> moves_;  ///< slots of a tied row -> of its root's
};

}  // namespace wetfront::mpm
