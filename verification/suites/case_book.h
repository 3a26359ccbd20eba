#pragma once

#include "fem_reference/richards_problem.h"
#include "mpm/problem.h"
#include "reports/record.h"
#include "verification/suites/case.h"
#include "verification/suites/point_runs.h"

#include <algorithm>
#include <string>
#include <vector>

namespace wetfront::verification {

/// What is allowed, in what unit ("1": relative), and why that much.
struct Gate {
  double tolerance;
  std::string unit;
  std::string reason;
};

/// The band of an observed order. Both ends are gated: an order far above the scheme's says that the ladder is not in
/// the asymptotic range, or that the error is not what it is called.
struct OrderGate {
  double lowest, highest;
  std::string reason;
};

/// What a case writes down while it runs: solutions with their cost and balance, findings, tables, figures.
class CaseBook {
 public:
  explicit CaseBook(const Case& test);

  /// Solves, enters the run into the table of runs and its water balance into the gate (finish()). Throws GaveUp.
  meshes::FieldHistory solve(const std::string& label, const fem_reference::RichardsProblem& problem);
  /// The same on material points; their balances and overshoot are gated too (point_runs.h). Throws mpm::GaveUp and
  /// mpm::CannotPlan.
  meshes::FieldHistory solve(const std::string& label, const mpm::Problem<2>& problem);
  void enter(const std::string& label, const mpm::Problem<2>& problem, const meshes::FieldHistory& history);
  /// A run that something else made: as solve() does.
  void enter(const std::string& label, const meshes::FieldHistory& history, double tolerance);
  /// States what is solved; the first that is said stays.
  void describe(reports::Table setup);
  /// Where the page came from: program, machine, this mesh, so many threads.
  void sign(const meshes::Mesh& mesh, int threads);
  /// CPU seconds spent outside solve(), on so many unknowns.
  void spend(double cpu_seconds, double degrees_of_freedom = 0) {
    record_.cpu_seconds += cpu_seconds;
    degrees_of_freedom_ = std::max(degrees_of_freedom_, degrees_of_freedom);
  }

  /// error <= gate.tolerance, else FAIL. `quantity` is the column of the matrix of cases: "error", "order", "front",
  /// "infiltration", "water_balance".
  void judge(const std::string& quantity, const std::string& description, double error, const Gate& gate);
  /// |measured - expected| <= gate.tolerance; with unit "1" relative to |expected|. Both numbers are on the page.
  void expect(const std::string& quantity, const std::string& description, double measured, double expected,
              const Gate& gate);
  /// Observed order between two errors whose mesh width (step, ...) differs by `ratio`.
  void judge_order(const std::string& quantity, const std::string& description, double order, const OrderGate& gate);
  /// Shown without a gate.
  void show(const std::string& quantity, const std::string& description, double value, const std::string& unit);
  void draw(reports::Figure figure) { record_.figures.push_back(std::move(figure)); }
  void tabulate(reports::Table table) { record_.tables.push_back(std::move(table)); }

  /// Adds the balance gate, the table of runs and the verdict.
  reports::Record finish(const std::string& failure = "");

 private:
  reports::Finding& add(const std::string& quantity, const std::string& description, double error, const Gate& gate);
  void judge_balance();
  void judge_points();
  reports::Record record_;
  reports::Table runs_;
  PointRuns point_runs_;
  struct Balance {
    double worst = 0;
    int runs = 0;
  } at_default_, at_reference_;
  double degrees_of_freedom_ = 0;
  std::string orders_;  ///< all that were observed
};

/// Largest |stored - stored_0 - infiltrated + outflow| over the run, relative to |inflow| + |outflow|: all that passed
/// any side (or came from a source), step by step in either direction. Water that only ran off does not count.
double relative_imbalance(const meshes::FieldHistory& history);

}  // namespace wetfront::verification
