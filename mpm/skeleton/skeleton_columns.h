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

/// Where the values of the columns lie while points stay in their slots.
template <int dim>
struct PointPlaces {
  explicit PointPlaces(const SkeletonColumns& c)
      : volume((*c.volume)[0]), mass((*c.mass)[0]), suction(c.suction != nullptr ? (*c.suction)[0] : nullptr) {
    for (int a = 0; a < dim; ++a) position[a] = (*c.position)[a], velocity[a] = (*c.velocity)[a];
    for (int q = 0; q < stress_components<dim>; ++q) stress[q] = (*c.stress)[q];
    for (int q = 0; c.affine != nullptr && q < dim * dim; ++q) affine[q] = (*c.affine)[q];
  }
  /// Asks for what a later cell works on: columns are more streams than the machine foresees.
  [[gnu::always_inline]] void fetch_motion(std::size_t slot) const {
    for (int a = 0; a < dim; ++a) __builtin_prefetch(position[a] + slot), __builtin_prefetch(velocity[a] + slot);
    __builtin_prefetch(mass + slot);
  }
  [[gnu::always_inline]] void fetch_stress(std::size_t slot) const {
    for (int q = 0; q < stress_components<dim>; ++q) __builtin_prefetch(stress[q] + slot);
    __builtin_prefetch(volume + slot);
  }

  std::array<double*, dim> position, velocity;
  std::array<double*, stress_components<dim>> stress;
  std::array<double*, dim * dim> affine{};
  double *volume, *mass, *suction;
};
template <int dim>
struct NodePlaces {
  explicit NodePlaces(const SkeletonColumns& c) : mass((*c.node_mass)[0]) {
    for (int a = 0; a < dim; ++a) {
      force[a] = (*c.node_force)[a], velocity[a] = (*c.node_velocity)[a], acceleration[a] = (*c.node_acceleration)[a];
      if (c.node_new_velocity != nullptr) new_velocity[a] = (*c.node_new_velocity)[a];
    }
  }
  double* mass;
  std::array<double*, dim> force, velocity, acceleration, new_velocity{};
};

/// Lanes that hold points among four slots, of which `left` and fewer are live.
[[gnu::always_inline]] inline LaneMask live_lanes(std::size_t left) {
  static constexpr double index[lane_count] = {0, 1, 2, 3};
  return load(index) < static_cast<double>(left);
}

/// Stores what a full chunk of lanes holds; beyond the live points nothing changes.
[[gnu::always_inline]] inline void store_live(const Lanes& value, double* to, const LaneMask& live) {
  store(select(live, value, load(to)), to);
}

}  // namespace wetfront::mpm
