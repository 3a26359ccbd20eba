#pragma once

#include "mpm/skeleton/skeleton_cycle.h"

namespace wetfront::mpm {

/// Momentum [N s] and energy [J] of a skeleton in a dynamic stage (meshes::MotionRow). Every step, at the nodes:
///
/// - impulse += dt sum (f_i - f_int,i): weight, loads, water
/// - reaction += dt sum (m_i a_i - f_i): sides, contact, damping (and drag, where the liquid moves too)
/// - works += dt sum of the same forces with (v_i + v_i')/2
///
/// where v_i' are the points' new velocities mapped back, as MUSL does: then the works sum to the change of the points'
/// own kinetic energy, to round-off as long as they take increments only. (With v_i + dt a_i in their place they would
/// sum to that of the nodes, which at a node with a sliver of mass, where f/m has no bound, is larger by any factor and
/// lost when points look.) Schemes that do not map back take v_i + dt a_i, with the same caution for light nodes as the
/// velocities that strain.
///
/// sum f_int is zero, so momentum of the points = first + impulse + reaction to round-off. What points held at the mesh
/// border lose of their velocity no node knows: it shows as drift. The energy does not close so: gravity's work is
/// taken from where points are, who move with other velocities than (v_i + v_i')/2, and shares of PIC lose some; the
/// row's `drift` is that. Has to join after all that acts on the nodes.
template <int dim>
class MotionLedger : public Effect<dim> {
 public:
  explicit MotionLedger(Origin origin, std::shared_ptr<SkeletonCycle<dim>> cycle)
      : Effect<dim>("motion ledger", std::move(origin), "sum m v, sum m v^2/2, works (mpm/record/motion_ledger.h)"),
        cycle_(std::move(cycle)) {}
  void join(StagePlan<dim>& plan) override;

 private:
  class First;
  class Last;
  /// Components of the run column.
  enum Entry {
    stress_work,
    load_work,
    resistance,
    first_energy,
    impulse,
    reaction = impulse + dim,
    first = reaction + dim,
    count = first + dim
  };

  void see_inner_force();
  void add_step();
  void add_impulse();
  void add_work(double share, bool with_change);
  void record(double time, meshes::FieldHistory& history) const;
  Vector<dim> momentum() const;
  double motion() const;
  double potential_energy() const;
  double brought(int entry) const;

  StagePlan<dim>* plan_ = nullptr;
  std::shared_ptr<SkeletonCycle<dim>> cycle_;
  const Column *mass_ = nullptr, *position_ = nullptr, *velocity_ = nullptr;  // points
  const Column* migrated_ = nullptr;                                          // run
  const Column *node_mass_ = nullptr, *force_ = nullptr, *node_velocity_ = nullptr, *acceleration_ = nullptr;
  Column *inner_ = nullptr, *loaded_ = nullptr, *sums_ = nullptr;
  Column* brought_ = nullptr;  ///< brought_by_water.h; nullptr where the mass of points stays
};

}  // namespace wetfront::mpm
