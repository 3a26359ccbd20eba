#pragma once

#include "mpm/seepage/seepage_step.h"
#include "mpm/skeleton/skeleton_cycle.h"

namespace wetfront::mpm {

/// The water's inertia against grains that move (README.md section 8b), in a step of TrueTimeMotion:
///
///   motion   V_p q_p stays; a_s = change of the points' velocity / dt
///   flow     rho_l [a_s + d(q/(nS))/dt] = -grad p + rho_l g - q/M, the body giving way (LiquidInertiaInMotion)
///   react    m_i dv_i = - sum_p N_i rho_l V_p (q_p - q_p of before the flow), points take sum N_i dv_i
///   pay      before the next motion: nodes move by 3/2 dt dv_i
///
/// What a held node would gain its support takes. Points carry "flux" q [m/s] and "skeleton acceleration", nodes
/// "displacement owed" [m].
template <int dim>
class RelativeInertia {
 public:
  /// Requires "brought by water" on the run, whose sums take in what points gain.
  RelativeInertia(StagePlan<dim>& plan, const SeepageColumns& columns, const SkeletonCycle<dim>& cycle);

  /// Points take Darcy's flux at the trial pressure when the scheme begins: from none the first one would be a blow.
  void begin(NodalWater<dim>& water);
  void before_motion();
  /// Stencils are not needed, volumes and velocities are those after a motion of `dt` s.
  void after_motion(double dt);
  /// After the flow of `dt` s; stencils filled.
  void react(double dt);

  bool owes() const;
  /// "velocity" of the nodes becomes what is owed over `dt` s, and their "displacement" grows by it.
  void pay(double dt);

 private:
  bool fresh_;  ///< no stage before has had a flux
  void find_change();

  StagePlan<dim>& plan_;
  SeepageColumns c_;
  const SkeletonCycle<dim>& cycle_;
  const Column *volume_, *mass_, *water_, *shape_;  ///< points
  Column *velocity_, *brought_;                     ///< points; the run
  Column *node_velocity_, *displacement_, *owed_;   ///< nodes
  std::vector<double> flux_before_;                 ///< of points, component by component [m/s]
  std::vector<double> change_, node_mass_;          ///< dv of nodes, component by component [m/s]; kg
};

}  // namespace wetfront::mpm
