#pragma once

#include "mpm/plan/stage_plan.h"

#include <functional>
#include <string>
#include <vector>

namespace wetfront::mpm {

/// Looks after a run whatever its scheme: a run never hangs, never crawls and never carries on with fields that cannot
/// be. All failures are StepFailed, so that what was computed before is kept.
///
/// - Every step: the water ledger is finite (it sums over all nodes and points).
/// - Every few steps: every carried column is finite, and with a rigid skeleton the pressures and the liquid's kinetic
///   energy are such that heads can cause. Richards' equation has a maximum principle in total head: none lies above
///   the highest of the initial heads, the rained surfaces and the prescribed heads; none below the lowest where
///   nothing can drain. Half of that range more is left to inertia and to the mesh.
/// - CPU time against Problem::cpu_budget, and steps so short that the stage would need very many of them.
template <int dim>
class RunGuard {
 public:
  struct Spent {
    double before;  ///< CPU seconds of the run before it was continued
    double since;   ///< reading of the thread's CPU clock when it was begun or continued
  };
  /// `steps_expected`: of this stage; asked only when the run seems to crawl, since the answer costs a few plans.
  RunGuard(const StagePlan<dim>& plan, Spent cpu, std::function<double()> steps_expected);

  void before_step(long steps_taken);
  void after_step(long steps_taken);
  /// Adds the counter "pressure beyond heads [Pa]": how far the pressures left what heads can cause, at the worst.
  void tell(meshes::FieldHistory& history) const;

 private:
  void check_budget() const;
  void check_crawl();
  void check_finite() const;
  void check_heads();
  void check_kinetic_energy() const;
  std::string where_time_went() const;
  [[noreturn]] void stop(const std::string& what, const char* kind, std::size_t at) const;

  const StagePlan<dim>& plan_;
  Spent cpu_;
  std::function<double()> steps_expected_;
  double most_steps_;                     ///< that the rest of the stage may need
  double window_start_ = -1;              ///< of the crawl check [s]; -1: not begun
  std::vector<double> highest_, lowest_;  ///< of the pressure at the nodes [Pa]; empty: not known
  double slack_ = 0, beyond_ = 0;         ///< allowed and met beyond these [Pa]
  double energy_per_water_ = 0;           ///< that heads can give [J/m3]
};

}  // namespace wetfront::mpm
