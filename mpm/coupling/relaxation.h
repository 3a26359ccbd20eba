#pragma once

#include "mpm/coupling/elastic_solve.h"
#include "mpm/coupling/stall_watch.h"
#include "mpm/skeleton/skeleton_cycle.h"

#include <functional>

namespace wetfront::mpm {

/// Brings a deforming skeleton to rest under the forces that act on it (README.md section 3): elastic corrections as
/// long as they help, damped motion otherwise.
///
/// Out of balance: sum |f| over the nodes and axes that can move / max(sum |f| where they are held, weight, the same
/// sum at its worst in this relaxation). A state within Relaxation::unbalanced_ratio is an equilibrium. Velocities are
/// zero before and after.
template <int dim>
class Relaxer {
 public:
  struct Outcome {
    long iterations = 0;      ///< cycles of the skeleton
    double ratio = 0;         ///< out of balance, at the end
    double displacement = 0;  ///< largest of a node [m]
    bool stalled = false;     ///< got no nearer to equilibrium, but is not so far from it that it has failed
  };

  /// Provides its columns and listens to the cycle's forces.
  Relaxer(StagePlan<dim>& plan, std::shared_ptr<SkeletonCycle<dim>> cycle);

  /// Forgets the stiffness: to be called at the beginning of every step of the plan, so that a continued run finds the
  /// same bits.
  void begin_step() {
    factorised_ = false;
    step_start_.assign(displacement_->values().begin(), displacement_->values().end());
  }
  /// Throws StepFailed when the state does not come to rest: with the ratio, how far it has moved, and whether it still
  /// speeds up. In a stage that ends with failure: SkeletonFailed by its FailureCriterion, where the displacement is
  /// that since the beginning of the step.
  Outcome run() { return relax(3 * crossing_); }
  /// The same with stress brought back to what the soil bears now, first: for a soil that has become weaker, whose
  /// stress is still in balance.
  Outcome run_weakened();

 private:
  class Listener;
  /// `stall_window`: iterations of StallWatch.
  Outcome relax(long stall_window);
  double imbalance();
  double kinetic_energy() const;
  void clear_velocities();
  bool correct();
  void move_by_cycle();
  [[noreturn]] void give_up(const Outcome& outcome) const;
  void look_for_failure(Outcome& outcome);
  /// How far each node with soil has moved, the farthest of them, and 5 % of them at least [m].
  std::vector<double> ways(const std::vector<double>& since) const;
  double moved(const std::vector<double>& since) const;
  double slid(const std::vector<double>& since) const;

  StagePlan<dim>& plan_;
  std::shared_ptr<SkeletonCycle<dim>> cycle_;
  Column *force_, *node_mass_, *node_velocity_, *acceleration_, *displacement_, *correction_, *unbalanced_;
  Column *velocity_, *affine_ = nullptr;  ///< of points
  std::unique_ptr<ElasticSolve<dim>> elastic_;
  bool factorised_ = false, elastic_possible_ = true;
  double shortest_ = 0;   ///< altitude of a cell [m]
  double strongest_ = 0;  ///< sum |f| that was out of balance at the worst in this relaxation [N]
  long most_iterations_ = 0, crossing_ = 1;
  StallWatch stall_;
  std::vector<double> start_, step_start_;  ///< displacement when the relaxation and the step of the plan began
  std::array<double, 4> energies_{};        ///< largest kinetic energy of the last wave crossings, newest first [J]
};

/// Each step of the plan is one relaxation: adds it to the plan, with its counts in the history.
template <int dim>
void add_relaxation(StagePlan<dim>& plan, std::function<typename Relaxer<dim>::Outcome()> relax);

/// A stage without liquid: each step of the plan is one relaxation.
template <int dim>
class QuasiStaticMotion : public Effect<dim> {
 public:
  QuasiStaticMotion(Origin origin, std::shared_ptr<SkeletonCycle<dim>> cycle)
      : Effect<dim>("quasi-static motion", std::move(origin),
                    "div sigma' + rho g = 0; local damping (Cundall 1987); mpm/coupling/README.md section 3"),
        cycle_(std::move(cycle)) {}
  void join(StagePlan<dim>& plan) override;

 private:
  std::shared_ptr<SkeletonCycle<dim>> cycle_;
  std::unique_ptr<Relaxer<dim>> relaxer_;
};

/// Writes what relaxations did into the history's counters.
struct RelaxationCounts {
  long iterations = 0, relaxations = 0, stalls = 0;
  double ratio = 0, displacement = 0;  ///< the worst

  template <class Outcome>
  void add(const Outcome& outcome) {
    iterations += outcome.iterations;
    ++relaxations;
    stalls += outcome.stalled;
    ratio = ratio > outcome.ratio ? ratio : outcome.ratio;
    displacement = displacement > outcome.displacement ? displacement : outcome.displacement;
  }
  /// Adds and starts anew.
  void tell(meshes::FieldHistory& history);
};

}  // namespace wetfront::mpm
