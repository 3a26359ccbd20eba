#pragma once

#include "verification/suites/hard/hard_case.h"

namespace wetfront::verification {

/// What became of one row in one column.
struct HardEntry {
  enum class Outcome { ran, refused, failed } outcome = Outcome::failed;
  HardScheme scheme;
  std::string said;            ///< the refusal or the failure; what was refused before the run was made shorter
  bool too_expensive = false;  ///< the refusal names a cost
  double estimate = 0;         ///< CPU seconds that a refused run would take
  double end = 0;              ///< s
  std::vector<Reading> readings;
  double balance = 0;           ///< |stored - stored_0 - infiltrated + outflow|, largest, over the water moved or
                                ///< stored; without what the hand-over between stages changed
  double handed_over = 0;       ///< |water that points were given or lost where a stage took it over|, over that stored
  double particle_balance = 0;  ///< the same with the sums over points, at the end
  double overshoot = 0;         ///< Pa beyond what heads can cause, largest of the run
  double energy_growth = 0;     ///< free energy gained beyond the work of the boundaries, over the energy converted
  double newton_failures = 0, rejected = 0, steps = 0, cpu = 0;
  meshes::FieldHistory history;
};

/// Runs one entry. Never throws for what the solver does.
HardEntry run_entry(const HardCase& test, HardScheme scheme);

/// The problem that an entry runs, with the end given.
mpm::Problem<2> entry_problem(const HardCase& test, HardScheme scheme, double end);

}  // namespace wetfront::verification
