#pragma once

#include "mpm/two_velocity/body.h"
#include "mpm/two_velocity/cut_surface.h"

#include <span>
#include <utility>
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
  /// Of a body that moves: its outer faces without rain.
  ImpermeableWalls(const Grid<dim>& grid, const Body<dim>& body);
  void find(const Grid<dim>& grid, const Body<dim>& body);

  /// Removes the forbidden directions from a vector at a node.
  void project(std::size_t node, Vector<dim>& v) const {
    if (walls_of_[node] < 0) return;
    const Node& walls = walls_[static_cast<std::size_t>(walls_of_[node])];
    for (int k = 0; k < walls.count; ++k) {
      const Vector<dim>& d = walls.direction[static_cast<std::size_t>(k)];
      double along = 0;
      for (int a = 0; a < dim; ++a) along += v[a] * d[a];
      for (int a = 0; a < dim; ++a) v[a] -= along * d[a];
    }
  }
  bool any(std::size_t node) const { return walls_of_[node] >= 0; }
  /// Nodes with walls, in the order in which the faces name them.
  std::size_t size() const { return walls_.size(); }
  std::size_t node(std::size_t k) const { return walls_[k].index; }
  /// No direction is left.
  bool closed(std::size_t node) const {
    return walls_of_[node] >= 0 && walls_[static_cast<std::size_t>(walls_of_[node])].count == dim;
  }

 private:
  struct Node {
    std::size_t index = 0;
    int count = 0;
    std::array<Vector<dim>, dim> direction{};  ///< orthonormal
  };
  /// A node and the share of a face there.
  using Share = std::pair<int, Vector<dim>>;
  void gather(std::size_t nodes);
  void forbid(std::span<const Vector<dim>> normals, Node& walls);

  std::vector<int> walls_of_;  ///< per node, into walls_; -1: none
  std::vector<Node> walls_;
  // Kept from one body to the next for their memory alone:
  std::vector<Share> shares_;
  std::vector<std::size_t> ends_;     ///< of the shares of each of walls_
  std::vector<Vector<dim>> normals_;  ///< the shares, node by node
  std::vector<Vector<dim>> groups_;
};

}  // namespace wetfront::mpm
