#pragma once

#include "mpm/seepage/bdf2.h"
#include "mpm/seepage/nodal_water.h"

#include <string>
#include <vector>

namespace wetfront::mpm {

/// The columns of `seepage`, all on nodes but the last three.
struct SeepageColumns {
  Column *pressure, *pressure_before, *pressure_earlier;  ///< p at t^n, t^{n-1}, t^{n-2} [Pa]
  Column *stored, *stored_before;                         ///< W at t^n, t^{n-1} [m^dim]
  Column* pore_volume;                                    ///< n V per region [m^dim]
  Column *outflow, *outflow_before;
  Column* steps;  ///< on the run: see StepMemory
  Column *point_pressure, *point_saturation;
  Column* flux = nullptr;  ///< q of the points [m/s], with inertia only
  /// With inertia on a skeleton that moves (coupling/relative_inertia.h), at the points: a_s [m/s2] over the step's
  /// motion, and n S/(1 - rho_l n S/rho) [-].
  Column *acceleration = nullptr, *yielding = nullptr;
};

/// Components of the run column "seepage steps".
enum StepMemory : int { step_last, step_before, step_history, step_proposal, step_memory_entries };

/// One accepted step of the nodal water balance: Newton's method with a backtracking line search inside a step that is
/// chosen by a local-error estimate (bdf2.h).
///
/// Error control compares the pressures of a step with their extrapolation: sqrt(mean of squares, weighted by pore
/// volume) / (the same of p + the retention curve's pressure scale) <= time_tolerance. This costs nothing beyond the
/// step itself; step doubling costs three times as much for an estimate of the same order.
/// After a break of the loading the history is dropped and one backward Euler step starts anew.
template <int dim>
class SeepageStep {
 public:
  SeepageStep(StagePlan<dim>& plan, NodalWater<dim>& water, const SeepageColumns& columns, double pressure_scale);

  /// Takes one step from clock.time, shortens clock.end when it must; throws StepFailed.
  void run();
  /// Takes the whole of the clock's step, by one backward Euler step or as many halves of it as it takes: where the
  /// skeleton rules the steps, which are far shorter than the flow's own.
  void cover();
  /// Sets sizes that depend on memory; call when columns are allocated.
  void prepare();
  double proposal() const;

  long newton_iterations = 0, rejected_steps = 0, failed_solves = 0, jumps_taken = 0;

 private:
  struct Formula {
    Bdf2Weights weights;
    StepPredictor predictor;
  };
  Formula formula(double dt) const;
  void predict(const Formula& formula);
  void evaluate();
  double residual(const Bdf2Weights& weights, double dt);  ///< largest |F_i| / pore volume
  bool newton(const Bdf2Weights& weights, double dt);
  bool couple(const Bdf2Weights& weights, double dt);
  void pin_open_level();
  /// p = start + length * update, within the limits of what stops at a kink.
  void take(double length);
  bool line_search(const Bdf2Weights& weights, double dt);
  double local_error(const StepPredictor& predictor) const;
  void accept(const Formula& formula, double dt);
  double first_step();
  void cover_part(double begin, double end);
  long most_failed_ = 0;  ///< of failed_solves in the step that is being covered
  /// Weather, levels and heads of the time that is about to be solved for.
  void tell_window(double begin, double end) const;
  [[noreturn]] void give_up(double dt) const;

  StagePlan<dim>& plan_;
  NodalWater<dim>& water_;
  SeepageColumns c_;
  double pressure_scale_;
  Kernel* linear_solve_;
  int shortest_in_a_row_ = 0;   ///< steps as short as steps can be
  bool level_may_be_open_;      ///< no soil stores water under pressure
  double shortest_controlled_;  ///< s: the error of a step this short is taken as it is
  std::vector<double> balance_, update_, start_, pore_volume_;
  std::vector<int> active_;
  std::vector<double> residuals_;  ///< of the present Newton iteration
  bool solved_ = false;
};

}  // namespace wetfront::mpm
