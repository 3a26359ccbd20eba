#pragma once

#include "mpm/boundary/faces.h"
#include "mpm/plan/stage_plan.h"

#include <map>

namespace wetfront::mpm {

/// Takes points to the cells they have moved to. Who moves points notes those that have left their cell; nothing is
/// done about the others. The only place where points change cells (and later, owners).
///
/// A point that would leave the mesh is held at its border: put back to the face it went through, a hair inside,
/// without the part of its velocity that points outwards. It is counted, and the count is told in the history: "points
/// held at the mesh border" (each time anew). One that leaves through a periodic side (`PeriodicSkeleton`) comes in
/// again at the partner, with all it carries: its place and its place at the start are moved by what lies between the
/// two, so displacements go on. "points handed to the periodic partner" counts these. A point may enter cells of
/// another soil and keeps its own. With two velocities, whose laws of water belong to cells, that stops the run.
template <int dim>
class Migration {
 public:
  /// Provides the step column "scratch" on points and "migration" on the run.
  explicit Migration(StagePlan<dim>& plan);
  /// One list for each of the chunks that note at the same time; their order is that of the points.
  void prepare(std::size_t chunks);
  std::vector<Mover>& leaving(std::size_t chunk) { return leaving_[chunk]; }
  /// Throws StepFailed when a point is nowhere (not a number) or, with two velocities, in cells of another soil.
  void run();

 private:
  bool find_cell(Mover& mover);
  bool beyond_mesh(const Vector<dim>& x) const;
  std::size_t hold(std::size_t cell, std::size_t slot, const Vector<dim>& x);
  void open_periodic_sides();
  int hand_over(std::size_t cell, std::size_t slot, const Vector<dim>& x);
  void stop_outward(std::size_t slot, const Vector<dim>& normal);

  StagePlan<dim>& plan_;
  Column &position_, &velocity_, &scratch_, &count_;
  std::vector<std::vector<Mover>> leaving_;
  std::vector<Mover> movers_;
  /// Of each periodic side of the mesh: to its partner.
  std::map<int, Vector<dim>> through_;
  std::unique_ptr<Faces<dim>> faces_;  ///< where there are such sides
  std::vector<int> across_;            ///< per face of a cell: the cell behind its image on the partner; -1: none
  const Column* mass_ = nullptr;       ///< of points, where there are such sides
  Vector<dim> low_{}, high_{};         ///< corners of the box around the mesh, a hair outside of it
};

/// Components of the run column "migration".
enum {
  migration_crossings,
  migration_held,
  migration_handed,  ///< to periodic partners
  migration_lifted,  ///< -sum m g . way of these [J]: potential energy that they did not gain by moving
  migration_counts
};

}  // namespace wetfront::mpm
