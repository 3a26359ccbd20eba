#pragma once

#include "verification/suites/mechanics/motion.h"

#include <optional>

namespace wetfront::verification {

/// Where the energy of a dynamic run went, from the beginning of its last stage to its end [J; per metre in two
/// dimensions]:
///
///     released + loads = kinetic + stored + dissipated + resisted + mapping
///
/// `mapping` is what the others leave: what points have and nodes do not show, of which shares of PIC take theirs each
/// step, and gravity's work at places that differ from those of the nodes. Without PIC it is a thousandth.
struct EnergySplit {
  double size = 0;                        ///< largest energy that was or went anywhere in the run
  double released = 0;                    ///< of the field of gravity
  double loads = 0;                       ///< work of tractions and water
  double kinetic = 0;                     ///< gained
  std::optional<double> stored;           ///< gained elastically; none where the law's stress is not linear in strain
  double stress_work = 0;                 ///< stored and dissipated
  double resisted = 0;                    ///< friction on the base, sides, damping
  double mapping = 0;                     ///< lost
  double worst_loss = 0, worst_gain = 0;  ///< of mapping, at any time of the run
};

/// Of a run with a ledger of motion (history.motion is not empty).
template <int dim>
EnergySplit energy_split(const mpm::Problem<dim>& problem, const Motion<dim>& motion);

}  // namespace wetfront::verification
