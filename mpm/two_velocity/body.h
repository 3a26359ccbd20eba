#pragma once

#include "mpm/boundary/faces.h"
#include "mpm/grid/active_nodes.h"
#include "mpm/plan/stage_plan.h"

#include <span>
#include <vector>

namespace wetfront::mpm {

/// The cells that hold points now, and the border of their union: what a moving body shows to the liquid. A function
/// of the occupied cells alone, found anew when they change, so that a continued run finds the same.
///
/// On the outer faces water passes as the rain says, and not at all where there is none (README.md section 5c).
template <int dim>
class Body {
 public:
  struct OuterFace {
    std::size_t cell = 0;
    int face = 0;
    bool border = false;     ///< on the border of the mesh
    std::vector<int> rains;  ///< indices of the water boundaries that rain on it; empty: a wall
  };
  explicit Body(const StagePlan<dim>& plan);

  /// Looks at the blocks; true when other cells hold points than before. What is found is a function of the cells
  /// that hold points now; what is looked at are those that have come or gone and their neighbours.
  bool update();
  /// By the last update: cells that have come, gone, or become part of the surface or not; nodes that no cell has any
  /// more.
  const std::vector<std::size_t>& changed() const { return changed_; }
  const std::vector<int>& left_nodes() const { return left_nodes_; }
  std::span<const OuterFace> outer() const { return {outer_.data(), outer_count_}; }
  const std::vector<std::size_t>& cells() const { return cells_; }
  /// Nodes of the occupied cells, ascending.
  const std::vector<int>& nodes() const { return nodes_; }
  /// The same as runs without a gap.
  const std::vector<NodeRun>& node_runs() const { return node_runs_; }
  /// Occupied cells with an outer face: they may be filled in part.
  const std::vector<std::size_t>& surface_cells() const { return surface_cells_; }
  bool at_surface(std::size_t cell) const { return at_surface_[cell] == surface_itself; }
  /// A surface cell that borders empty space or is rained upon; others merely lie at a wall of the mesh.
  bool is_open(std::size_t cell) const { return open_[cell] != 0; }
  /// Surface cells and the occupied cells across their faces: those that slivers concern.
  const std::vector<std::size_t>& near_surface() const { return near_; }
  bool is_near_surface(std::size_t cell) const { return at_surface_[cell] != 0; }
  const Faces<dim>& faces() const { return faces_; }
  bool occupied(int cell) const { return cell >= 0 && occupied_[static_cast<std::size_t>(cell)] != 0; }

 private:
  static constexpr char next_to_surface = 1, surface_itself = 2;
  void change(std::size_t cell, bool occupied);
  void find_nodes();
  void find_outer();
  void find_surface();
  void rain_on(OuterFace& outer) const;
  void shade();

  const StagePlan<dim>& plan_;
  Faces<dim> faces_;
  std::vector<int> rain_, side_of_rain_;  ///< water boundaries that are rain; their side, -1: the free surface
  std::vector<char> seeps_;               ///< of each rain: it never falls, a seepage face
  Vector<dim> up_{};
  long version_ = -1;  ///< of the points' cells when they were last looked at
  std::vector<std::size_t> cells_, cells_before_, surface_cells_, surface_before_, near_, changed_;
  std::vector<char> occupied_, at_surface_, open_, was_surface_;
  std::vector<char> looked_at_;    ///< cells that may have outer faces
  std::vector<int> cells_around_;  ///< nodes: of the occupied cells
  std::vector<int> nodes_, left_nodes_;
  std::vector<NodeRun> node_runs_;
  std::vector<OuterFace> outer_;  ///< the first outer_count_ of them: the others keep the room of their lists
  std::size_t outer_count_ = 0;
  /// A rained face as the sky sees it.
  struct Roof {
    double from, until, height;
    OuterFace* face;
  };
  std::vector<Roof> roofs_;  ///< scratch of shade
};

}  // namespace wetfront::mpm
