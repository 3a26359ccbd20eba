#pragma once

#include "mpm/problem.h"
#include "reports/record.h"

#include <string>

namespace wetfront::verification {

/// What every run of the material point method owes, whatever its case is about. Shares are of the water that passed
/// the sides in either direction.
struct WaterAudit {
  /// max |asked - run-off - delivered|, delivered = change of stored water + outflow, from what the scheme conserves
  /// (nodes or cells) and from the sums over points. No boundary code enters but the booked run-off.
  double nodes = 0, points = 0;
  /// By how much p exceeds, at any output time [Pa], what it may at most be: 0 on sides under rain (nothing is ponded),
  /// elsewhere rho g (H - z), H the largest total head of the start and of the sides (maximum principle). Gauges are
  /// read at every step.
  double overshoot = 0;
};
WaterAudit audit(const mpm::Problem<2>& problem, const meshes::FieldHistory& history);

/// Table and tallies of the runs of one case.
class PointRuns {
 public:
  PointRuns();
  void enter(const std::string& label, const mpm::Problem<2>& problem, const meshes::FieldHistory& history);
  bool empty() const { return table_.rows.empty(); }
  const reports::Table& table() const { return table_; }

  struct Worst {
    int runs = 0;
    WaterAudit audit;
  };
  const Worst& seepage() const { return seepage_; }
  const Worst& two_velocities() const { return two_velocities_; }  ///< runs with a stage that is not seepage

 private:
  reports::Table table_;
  Worst seepage_, two_velocities_;
};

}  // namespace wetfront::verification
