#pragma once

#include "mpm/grid/active_nodes.h"
#include "mpm/grid/chunks.h"
#include "mpm/grid/covered_cells.h"
#include "mpm/grid/migration.h"
#include "mpm/grid/spline_grid.h"
#include "mpm/plan/team.h"
#include "mpm/skeleton/skeleton_columns.h"
#include "mpm/skeleton/skeleton_cycle.h"
#include "mpm/skeleton/soil_motion.h"

namespace wetfront::mpm {

/// Skeleton that deforms, explicit in time (Lee 2021, steps I to IX without liquid; README.md here): any law of
/// mpm/laws/, MUSL, USF or USL, FLIP with a share of PIC or APIC, with or without B-bar, local damping, fixed sides.
///
/// Provides on points "mass", "velocity", "stress" (and the memory of its laws), on nodes "mass", "force", "velocity",
/// "acceleration" and "displacement". What else acts on it: skeleton_cycle.h.
template <int dim>
class DeformingSkeleton : public Effect<dim> {
 public:
  explicit DeformingSkeleton(Origin origin);
  void join(StagePlan<dim>& plan) override;
  std::shared_ptr<SkeletonCycle<dim>> cycle() const { return cycle_; }

 private:
  void provide_columns(StagePlan<dim>& plan);
  void provide_variants(StagePlan<dim>& plan);
  void begin_points(StagePlan<dim>& plan);
  void begin_affine(StagePlan<dim>& plan);
  void find_fixed(StagePlan<dim>& plan);
  void choose_laws(StagePlan<dim>& plan);
  void add_kernels(StagePlan<dim>& plan);
  void add_limits(StagePlan<dim>& plan);
  void tell(StagePlan<dim>& plan);

  void refresh();
  template <class Body>
  void over_chunks(const Body& body);
  void gather();
  void gather_cells(bool motion, bool force);
  void push();
  void accelerate();
  void add_weight();
  void divide_momentum();
  void points();
  void velocity();
  void move(bool strain, bool move);
  void find_rates();
  void keep_rates();
  void hold_fixed(Column& vector) const;
  void find_light();
  /// Share of dt a_i in the velocities that strain points where these are not mapped back (USL, the gradients of APIC):
  /// a node that a point has only just reached has a force but hardly a mass, f/m there has no bound. Points take the
  /// whole of the accelerations all the same, so momentum is kept.
  double strained(std::size_t node) const { return std::min(1.0, (*c_.node_mass)[0][node] / light_); }
  void stop_fixed() const;

  StagePlan<dim>* plan_ = nullptr;
  std::shared_ptr<SkeletonCycle<dim>> cycle_;
  SkeletonColumns c_;
  const Column* gravity_ = nullptr;
  Column* body_ = nullptr;                 ///< points, acceleration given by the problem
  Column* rates_ = nullptr;                ///< run: per soil the largest (c/h)^2 and (v/h)^2 [1/s2]
  std::array<std::vector<int>, 3> fixed_;  ///< nodes, per axis
  std::vector<std::unique_ptr<SoilMotion<dim>>> soils_;
  std::unique_ptr<Migration<dim>> migration_;
  std::unique_ptr<Chunks<dim>> chunks_;
  std::unique_ptr<CoveredCells<dim>> covered_;  ///< of mixed integration
  std::unique_ptr<SplineGrid<dim>> splines_;    ///< where they move the skeleton; null: linear functions
  std::unique_ptr<Team> team_;
  std::unique_ptr<ActiveNodes> active_;
  std::vector<MoveFindings> found_;  ///< per soil and chunk
  double light_ = 0;                 ///< a tenth of the heaviest node [kg]
  long version_ = -1;                ///< of the points' cells when chunks and active nodes were found
};

}  // namespace wetfront::mpm
