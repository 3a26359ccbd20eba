#pragma once

#include <array>
#include <string>

namespace wetfront::mpm {

/// The ordered steps of one cycle: steps I to IX of Lee et al. 2021, "time marching procedure" (MUSL).
/// Kernels of one phase run in the order in which their effects joined the plan.
enum class Phase {
  gather,          ///< I    stencils, nodal sums of point quantities
  accelerate,      ///< II   nodal forces and accelerations (Eqs 10, 11), then what corrects them (fixities, rain)
  point_velocity,  ///< III  points from accelerations (Eq. 13), nodal velocities mapped back (Eq. 14)
  strain,          ///< IV   strain rates (Eq. 15) and vorticity (Eq. 17)
  stress,          ///< V    effective stress (Eq. 16)
  pressure,        ///< VI   pore pressure (Eq. 18; the whole implicit solve of `seepage`)
  saturation,      ///< VII  saturation and relative permeability (Eqs 5 to 7)
  move,            ///< VIII volumes and positions (Eq. 19)
  carry,           ///< IX   points to their new cells, ledger, gauges
};
constexpr int phase_count = 9;

inline std::string phase_name(Phase phase) {
  static const std::array<std::string, phase_count> names{"I gather",       "II accelerate", "III point velocity",
                                                          "IV strain",      "V stress",      "VI pressure",
                                                          "VII saturation", "VIII move",     "IX carry"};
  return names[static_cast<std::size_t>(phase)];
}

}  // namespace wetfront::mpm
