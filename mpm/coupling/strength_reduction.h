#pragma once

#include "mpm/simulation.h"

namespace wetfront::mpm {

/// Factors of safety by strength reduction (Zienkiewicz, Humpheson & Lewis 1975; Dawson, Roth & Drescher 1999) of
/// states of a run, which is not touched: every trial works on its own copy (README.md section 11).

struct SafetySearch {
  double tolerance = 0.01;  ///< width of the last bracket of the factor [-]
  double largest = 4;       ///< a body that stands at it is not weakened further [-]
};
struct SafetyFactor {
  double stands = 1;       ///< largest factor with which the body came to rest
  double fails = 0;        ///< smallest with which it failed; 0: it stood with the largest that was asked for
  long trials = 0;         ///< relaxations of a weakened body
  long stalled = 0;        ///< of them, those that ran out of iterations within the ratio that counts as standing
  double cpu_seconds = 0;  ///< of the trials
};

/// The soil with c'/F, tan phi'/F and tan psi/F, of peak and residual alike, and c_max/F of strength by suction. The
/// cut- off of tension stays, but for the apex, which the stress law holds it to. Throws CannotPlan for a law that has
/// no strength to be divided, and where friction grows with suction (an angle that is no sum any more when it is
/// reduced).
Soil weakened(const Soil& soil, double factor);

/// The factor of a state in a quasi-static stage (CannotPlan in any other): strength is divided by 1 + .1, + .2, + .4,
/// ... until the body fails by the FailureCriterion of its stage, from the same state each time and with its pore
/// pressures, then the bracket is halved.
template <int dim>
SafetyFactor factor_of_safety(const Problem<dim>& problem, const State& state, const SafetySearch& search = {});

}  // namespace wetfront::mpm
