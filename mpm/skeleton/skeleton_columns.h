#pragma once

#include "mpm/lanes.h"
#include "mpm/laws/tensor.h"
#include "mpm/plan/column.h"

#include <vector>

namespace wetfront::mpm {

/// The columns a deforming skeleton works on. Those that are not called for are null.
struct SkeletonColumns {
  Column *position = nullptr, *volume = nullptr, *mass = nullptr, *velocity = nullptr, *stress = nullptr;  // points
  Column* affine = nullptr;            ///< points, APIC: [a*dim+b] = dv_a/dx_b [1/s]
  Column* initial_position = nullptr;  ///< points, where accelerations are given by where they began
  Column* suction = nullptr;           ///< points, where a law needs it
  Column *node_mass = nullptr, *node_force = nullptr, *node_velocity = nullptr, *node_acceleration = nullptr,
         *node_displacement = nullptr;
  Column* node_new_velocity = nullptr;  ///< v_i + dt a_i, where points take some of it
};

/// Lanes that hold points among four slots, of which `left` and fewer are live.
inline LaneMask live_lanes(std::size_t left) {
  static const Lanes index([](auto k) { return static_cast<double>(k); });
  return index < static_cast<double>(left);
}

/// Stores what a full chunk of lanes holds; beyond the live points nothing changes.
inline void store_live(const Lanes& value, double* to, const LaneMask& live) {
  store(select(live, value, load(to)), to);
}

/// Adds the sums over the lanes of each of `count` values to to[k].
template <std::size_t count>
[[gnu::always_inline]] inline void lane_sums(const std::array<Lanes, count>& values, std::array<double, count>& to) {
  for (std::size_t k = 0; k < count; ++k) to[k] = sum(values[k]);
}

}  // namespace wetfront::mpm
