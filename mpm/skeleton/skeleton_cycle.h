#pragma once

#include "mpm/grid/active_nodes.h"
#include "mpm/plan/stage_plan.h"

#include <array>
#include <memory>
#include <vector>

/// What a deforming skeleton shares with the effects that act on it: sides, contact, relaxation, water.
namespace wetfront::mpm {

/// Something that acts on the nodes of the skeleton. All act in the order in which they joined, after the fixities.
/// Columns of nodes (component per axis): "mass" m_i, "force" f_i, "velocity", "acceleration".
template <int dim>
class NodalCondition {
 public:
  virtual ~NodalCondition() = default;
  /// Adds to "force" [N]: tractions, pulls of water, reactions. "velocity" holds v_i at the beginning of the step.
  virtual void add_force() {}
  /// All forces are there, damping is not yet: who measures balance looks here, and changes nothing.
  virtual void see_force() {}
  /// Changes "acceleration" (a_i = f_i/m_i with damping so far) so that v_i + dt a_i is what the condition allows.
  virtual void limit_acceleration() {}
  /// MUSL: "velocity" is the points' momentum mapped back, over the nodes' mass, and nothing is held yet; changes
  /// nothing.
  virtual void see_velocity() {}
  /// Changes "velocity", the one that strains the points and moves them: v_i + dt a_i, or in MUSL the one mapped back
  /// from the points. The skeleton's displacement of nodes is summed after that.
  virtual void limit_velocity() {}
  /// A relaxation does not end while this is false: something is still on its way.
  virtual bool settled() const { return true; }
};

/// One cycle of the skeleton, as kernels to be run in this order:
///
///   gather       clears the nodes; mass, "velocity" = momentum sum m_p v_p N_i [kg m/s], "force" = internal force
///                - sum V_p sigma'_p grad N_i (B-bar: README.md)
///   (here, still in Phase::gather, effects that joined later may add to "force")
///   accelerate   "velocity" = momentum/mass; weight; add_force, see_force of the conditions; damping; a = f/m;
///                fixities and limit_acceleration
///   points       points' velocities; MUSL: their momentum back to the nodes
///   velocity     nodal velocities, fixities and limit_velocity; nodal displacement
///   move         strain, stress, volume, position of the points
///   migrate      points to their new cells
///
/// In a dynamic stage they are kernels of the plan: gather in Phase::gather, accelerate in Phase::accelerate, points
/// and velocity in Phase::point_velocity, move in Phase::move (stress update first: Phase::gather), migrate in
/// Phase::carry. In a quasi-static stage the plan runs none of them: they are iterated kernels of mpm/coupling/, which
/// sets `dt` and `damping` and runs them as often as it takes.
template <int dim>
struct SkeletonCycle {
  double dt = 0;       ///< of the cycle [s]; the clock's in a dynamic stage, relaxation's own in a quasi-static one
  double damping = 0;  ///< local (Cundall), f -= damping |f| sign(v) [-]
  std::vector<std::unique_ptr<NodalCondition<dim>>> conditions;
  const ActiveNodes* active = nullptr;  ///< nodes around points; the columns hold nothing of value at the others

  Kernel *gather = nullptr, *accelerate = nullptr, *points = nullptr, *velocity = nullptr, *move = nullptr,
         *migrate = nullptr;
  /// The longest stable dt at the present state, without a safety factor [s].
  std::function<double()> stable_step;
  /// The least time in which a point crosses its cell, h/|v| [s].
  std::function<double()> crossing;

  /// Nodes held by fixities, per axis: 1 where held. Reactions there do not count as out of balance.
  std::array<std::vector<char>, 3> fixed;
};

}  // namespace wetfront::mpm
