#pragma once

#include "fem_reference/stage/flat_top.h"
#include "fem_reference/stage/wetting_limit.h"

#include <span>
#include <string>
#include <vector>

namespace wetfront::fem_reference {

/// The nonlinear problem to which every time integrator reduces (README, Eq 4): find psi and released >= 0 with
///   m_i (W(psi_i) - target_i) = tau (R_i(psi) + rain_i - released_i),
/// where on rain sides psi_i <= 0, released_i >= 0, psi_i released_i = 0, and on head sides psi_i is given; rain_i is
/// less the demand of evaporation, and released_i < 0 is the part of it that is not met: 0 for psi_i > lowest, all of
/// it for psi_i < lowest, in between for psi_i = lowest. Full Newton with a fresh analytic Jacobian; the rain sides by
/// a primal-dual active set inside it (Hintermueller, Ito & Kunisch 2002), so the complementarity is exact and has no
/// penalty parameter.
class StageKernel {
 public:
  /// `newton_tolerance`: residual of a row as a water content [-].
  StageKernel(FlowOperator& flow, Boundary& boundary, double newton_tolerance);

  /// Moves given heads and sources to the time of the stage.
  void set_time(double time) {
    boundary_.set_stage_time(time);
    flow_.set_time(time);
  }
  /// `head` [dof, m] is the guess and becomes the solution; false when Newton did not converge (see failure()).
  bool solve(std::span<const double> target, double tau, std::span<double> head);

  /// Puts heads on the boundary that the conditions do not allow where they belong (given heads; psi <= 0 on
  /// rain sides) and returns the water [m^dim] that this takes out, per condition.
  std::vector<double> make_consistent(std::vector<double>& head) const;
  /// dW/dt [1/s] and the active set at a given state, e.g. at the start and after a jump of the rain.
  std::vector<double> rates(std::span<const double> head);

  /// Water released at the held dofs in the last solve() or rates() [m^dim/s], as Boundary::held().
  const std::vector<double>& released() const { return released_; }
  /// What the ledger integrates: run-off per held dof, then outflow per condition, then, where anything demands water,
  /// the unmet demand per held dof, and last, where the problem has a source, its total [m^dim/s].
  void ledger_rates(std::span<double> rates) const;
  std::size_t ledger_size() const {
    return boundary_.held().size() * (boundary_.has_demand() ? 2 : 1) + boundary_.condition_count() +
           (flow_.has_source() ? 1 : 0);
  }

  /// How far psi at a dof may be off [m] although W is right to the Newton tolerance: that tolerance over the capacity
  /// at the last evaluation, near saturation (where the capacity may vanish) the head at which W has dropped by it.
  double open_head(int dof, double head) const;
  /// The same on the dry side, where the capacity falls to nothing, for W right to `water`; 0 elsewhere [m].
  double open_dry_head(int dof, double head, double water) const;

  /// Why the last solve() failed.
  struct Failure {
    int dof = 0;                    ///< where the residual is largest, of this rank's
    double worst = 0;               ///< residual there
    double head = 0;                ///< psi there [m]
    std::vector<double> residuals;  ///< per iteration, max |residual| / m_i as a water content [-]
    std::string reason;
  };
  const Failure& failure() const { return failure_; }

  const FlowOperator& flow() const { return flow_; }
  const Boundary& boundary() const { return boundary_; }
  long iterations = 0, solves = 0, failed_solves = 0, evaluations = 0;
  Cost linear_solve_cost;

 private:
  void evaluate(std::span<const double> head);
  void residual(std::span<const double> target, double tau);
  bool update_active_set(double tau, std::span<const double> head);
  double worst_residual(int& dof, double& ratio) const;
  double agree(bool& changed, double& ratio) const;
  bool newton_step(double tau, std::span<double> head, double share);
  void hold_rows(std::span<const double> head);
  /// What a rain side does at a dof: passes everything; ponded at psi = 0; at psi = lowest with part of the demand met;
  /// drier than that with none.
  enum class Mode : char { free, ponded, dry_held, dry_free };
  bool is_held(std::size_t h) const;
  double held_head(std::size_t h) const;
  double offered(std::size_t h) const;
  bool update_mode(std::size_t h, double tau, double head);
  Mode mode_of_rates(std::size_t h, double head, double row) const;
  double tolerance(int dof) const;

  FlowOperator& flow_;
  Boundary& boundary_;
  WettingLimit limit_;
  double newton_tolerance_;
  std::vector<FlatTop> flat_tops_;  ///< per soil
  std::vector<Mode> mode_;          ///< per held dof of kind rain: the active set
  std::vector<double> released_;    ///< per held dof
  std::vector<double> residual_;    ///< per dof
  std::vector<double> rounding_;    ///< per dof: size of a rounding error in its residual
  SparseMatrix matrix_;
  std::unique_ptr<LinearSolver> linear_;
  Failure failure_;
};

}  // namespace wetfront::fem_reference
