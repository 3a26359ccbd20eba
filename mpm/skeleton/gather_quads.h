#pragma once

#include "mpm/skeleton/gather_cell.h"

#include <algorithm>
#include <span>

namespace wetfront::mpm {

/// GatherCell for quadrilaterals without affine velocities, written out: points are summed with nodes in lanes as soon
/// as they are weighed, so that all sums of a cell stay in registers, and sums per direction use
///   dN_i/du = -+ (1 - v), +- v,   dN_i/dv = -+ (1 - u), +- u.
class GatherQuads {
 public:
  GatherQuads(const LinearShape<2>& shape, const SkeletonColumns& columns, GatherParts parts)
      : shape_(shape), point_(columns), node_(columns), parts_(parts) {}

  [[gnu::always_inline]] void operator()(std::span<const Block> blocks) {
    // Mean stresses of some cells first, so that no sum waits for a division.
    constexpr std::size_t batch = 16;
    std::array<Mean, batch> means;
    for (std::size_t first = 0; first < blocks.size(); first += batch) {
      const std::size_t count = std::min(batch, blocks.size() - first);
      for (std::size_t k = 0; k < count; ++k) {
        const Block& block = blocks[first + k];
        point_.fetch_motion(block.first);
        if (first + k + batch < blocks.size()) point_.fetch_stress(blocks[first + k + batch].first);
        if (parts_.force) means[k] = mean_of(block);
      }
      for (std::size_t k = 0; k < count; ++k) pass(blocks[first + k], means[k]);
    }
  }

 private:
  using Place = std::array<Lanes, 2>;
  /// Sums at the four nodes of the cell.
  struct Sums {
    Lanes mass{0.0};
    std::array<Lanes, 2> momentum{}, pull{};
    Lanes spherical{0.0};  ///< sum V tr(sigma')/3, points in lanes
  };
  /// Volume on which the mean stress of the points of a covered cell acts, and that stress (0 elsewhere).
  struct Mean {
    double volume = 0;
    alignas(32) std::array<double, lane_count> stress{};
  };

  [[gnu::always_inline]] Mean mean_of(const Block& block) const {
    Mean mean;
    mean.volume = parts_.covered != nullptr ? parts_.covered[block.cell] : 0;
    if (mean.volume == 0) return mean;
    Lanes volume(0.0);
    std::array<Lanes, 4> stress{};
    for (std::size_t p = block.first; p < block.first + block.count; p += lane_count) {
      const Lanes v = load(point_.volume + p);
      volume += v;
      each<4>([&](auto q) __attribute__((always_inline)) { stress[q] += v * load(point_.stress[q] + p); });
    }
    store(sums(stress[0], stress[1], stress[2], stress[3]) / sum(volume), mean.stress.data());
    return mean;
  }

  [[gnu::always_inline]] void pass(const Block& block, const Mean& mean) {
    shape_.enter(block);
    if (parts_.motion && parts_.force)
      shape_.affine() ? sum_up<true, true, true>(block, mean) : sum_up<true, true, false>(block, mean);
    else if (parts_.motion)
      sum_up<true, false, false>(block, mean);
    else
      sum_up<false, true, false>(block, mean);
  }
  template <bool motion, bool force, bool affine>
  [[gnu::always_inline]] void sum_up(const Block& block, const Mean& mean) const {
    Sums to;
    for (std::size_t p = block.first; p < block.first + block.count; p += lane_count) {
      const Place x{load(point_.position[0] + p), load(point_.position[1] + p)};
      typename LinearShape<2>::Stencil at;
      if constexpr (force && !affine)
        shape_.map(x, at);
      else
        shape_.places(x, at);
      const Place& u = at.local;
      const Place other{1.0 - u[0], 1.0 - u[1]};
      if constexpr (motion) add_motion(p, u, other, to);
      if constexpr (force) add_force<affine>(p, at, other, mean, to);
    }
    if constexpr (force)
      if (parts_.b_bar || mean.volume > 0) add_mean(mean, sum(to.spherical), to.pull);
    if constexpr (motion) shape_.add_to_nodes(to.mass, node_.mass);
    each<2>([&](auto a) __attribute__((always_inline)) {
      if constexpr (motion) shape_.add_to_nodes(to.momentum[a], node_.velocity[a]);
      if constexpr (force) shape_.add_to_nodes(to.pull[a], node_.force[a]);
    });
  }

  [[gnu::always_inline]] void add_motion(std::size_t p, const Place& u, const Place& other, Sums& to) const {
    const Lanes m = load(point_.mass + p), left = m * other[0], right = m * u[0];
    const Lanes share[4] = {left * other[1], right * other[1], right * u[1], left * u[1]};
    to.mass += sums(share[0], share[1], share[2], share[3]);
    each<2>([&](auto a) __attribute__((always_inline)) {
      const Lanes v = load(point_.velocity[a] + p);
      to.momentum[a] += sums(share[0] * v, share[1] * v, share[2] * v, share[3] * v);
    });
  }

  template <bool affine>
  [[gnu::always_inline]] void add_force(std::size_t p, const typename LinearShape<2>::Stencil& at, const Place& other,
                                        const Mean& cell, Sums& to) const {
    const Lanes volume = load(point_.volume + p);
    std::array<Lanes, 4> s;
    each<4>([&](auto q)
                __attribute__((always_inline)) { s[q] = volume * (load(point_.stress[q] + p) - cell.stress[q]); });
    if (parts_.b_bar) {
      const Lanes mean = (s[0] + s[1] + s[2]) * (1.0 / 3);
      to.spherical += mean;
      s[0] -= mean, s[1] -= mean;
    }
    each<2>([&](auto a) __attribute__((always_inline)) {
      // V sigma' along the local axes, split between the sides they pull at.
      const Lanes &sx = s[a == 0 ? 0 : 3], &sy = s[a == 0 ? 3 : 1];
      Lanes along0, along1;
      if constexpr (affine) {
        along0 = sx * shape_.inverse(0, 0) + sy * shape_.inverse(0, 1);
        along1 = sx * shape_.inverse(1, 0) + sy * shape_.inverse(1, 1);
      } else {
        along0 = sx * at.inverse[0][0] + sy * at.inverse[0][1];
        along1 = sx * at.inverse[1][0] + sy * at.inverse[1][1];
      }
      const Lanes low0 = along0 * other[1], up0 = along0 * at.local[1];
      const Lanes low1 = along1 * other[0], up1 = along1 * at.local[0];
      to.pull[a] += sums(low0 + low1, up1 - low0, -up0 - up1, up0 - low1);
    });
  }

  /// What acts through the mean gradients: the points' own mean stresses (B-bar) and that of the cell.
  [[gnu::always_inline]] void add_mean(const Mean& mean, double spherical, std::array<Lanes, 2>& pull) const {
    const std::array<Lanes, 2> gradient = shape_.mean_gradients();
    const double xx = mean.volume * mean.stress[0] + spherical, yy = mean.volume * mean.stress[1] + spherical,
                 xy = mean.volume * mean.stress[3];
    pull[0] -= gradient[0] * xx + gradient[1] * xy;
    pull[1] -= gradient[0] * xy + gradient[1] * yy;
  }

  LinearShape<2> shape_;
  PointPlaces<2> point_;
  NodePlaces<2> node_;
  GatherParts parts_;
};

}  // namespace wetfront::mpm
