#include "verification/suites/mechanics/lagrangian_block.h"

#include <algorithm>
#include <cmath>

namespace wetfront::verification {

namespace {

using Pair = std::array<double, 2>;

/// A square of bilinear functions, its nodes against the clock from the lower left.
class Square {
 public:
  explicit Square(double size) : size_(size) {
    const double g = 1 / std::sqrt(3.0);
    place_ = {{{-g, -g}, {g, -g}, {g, g}, {-g, g}}};
    for (std::size_t q = 0; q < 4; ++q) {
      const auto [s, t] = place_[q];
      slope_[q] = {{{-(1 - t), -(1 - s)}, {1 - t, -(1 + s)}, {1 + t, 1 + s}, {-(1 + t), 1 - s}}};
      for (Pair& d : slope_[q]) d = {d[0] / (2 * size), d[1] / (2 * size)};
    }
  }
  double height(std::size_t q) const { return 0.5 * size_ * (1 + place_[q][1]); }  ///< above its lower edge [m]
  const Pair& slope(std::size_t q, std::size_t node) const { return slope_[q][node]; }
  double weight() const { return 0.25 * size_ * size_; }

 private:
  double size_;
  std::array<Pair, 4> place_;
  std::array<std::array<Pair, 4>, 4> slope_;
};

class Body {
 public:
  explicit Body(const InclineBlock& block)
      : block_(block),
        square_(block.cell),
        along_(static_cast<std::size_t>(std::lround(block.length / block.cell))),
        over_(static_cast<std::size_t>(std::lround(InclineBlock::height / block.cell))),
        mass_((along_ + 1) * (over_ + 1)),
        moved_(mass_.size()),
        velocity_(mass_.size()),
        force_(mass_.size()) {
    for (std::size_t e = 0; e < along_ * over_; ++e)
      for (const std::size_t node : nodes(e)) mass_[node] += InclineBlock::density * square_.weight();
  }
  double stable_step() const {
    return 0.6 * block_.cell / std::sqrt(2.0) / std::sqrt(oedometric() / InclineBlock::density);
  }
  void step(double dt) {
    add_up_forces();
    const Pair g = {InclineBlock::gravity * std::sin(InclineBlock::slope),
                    -InclineBlock::gravity * std::cos(InclineBlock::slope)};
    for (std::size_t i = 0; i < mass_.size(); ++i) {
      for (std::size_t a = 0; a < 2; ++a) velocity_[i][a] += dt * (force_[i][a] / mass_[i] + g[a]);
      if (i <= along_) meet_base(i, dt);
      for (std::size_t a = 0; a < 2; ++a) moved_[i][a] += dt * velocity_[i][a];
    }
  }
  BlockState state(double time) const {
    BlockState out{time, {}, {}};
    double mass = 0;
    for (std::size_t i = 0; i < mass_.size(); ++i) {
      mass += mass_[i];
      for (std::size_t a = 0; a < 2; ++a)
        out.place[a] += mass_[i] * moved_[i][a], out.velocity[a] += mass_[i] * velocity_[i][a];
    }
    for (std::size_t a = 0; a < 2; ++a) out.place[a] /= mass, out.velocity[a] /= mass;
    return out;
  }

 private:
  static double oedometric() {
    constexpr double nu = InclineBlock::poisson;
    return InclineBlock::young * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  }
  std::array<std::size_t, 4> nodes(std::size_t element) const {
    const std::size_t first = element / along_ * (along_ + 1) + element % along_;
    return {first, first + 1, first + along_ + 2, first + along_ + 1};
  }
  /// Stress at the start: of what lies above, K_0 = nu/(1 - nu) of it along the base.
  double resting(double height_of_place) const {
    return -InclineBlock::density * InclineBlock::gravity * std::cos(InclineBlock::slope) *
           (InclineBlock::height - height_of_place);
  }
  void add_up_forces() {
    constexpr double nu = InclineBlock::poisson, shear = InclineBlock::young / (2 * (1 + nu)), k0 = nu / (1 - nu);
    std::fill(force_.begin(), force_.end(), Pair{});
    for (std::size_t e = 0; e < along_ * over_; ++e) {
      const auto corner = nodes(e);
      for (std::size_t q = 0; q < 4; ++q) {
        double xx = 0, yy = 0, xy = 0;
        for (std::size_t i = 0; i < 4; ++i) {
          const Pair &d = square_.slope(q, i), &u = moved_[corner[i]];
          xx += d[0] * u[0], yy += d[1] * u[1], xy += d[1] * u[0] + d[0] * u[1];
        }
        const double rest = resting(static_cast<double>(e / along_) * block_.cell + square_.height(q));
        const double sxx = oedometric() * (xx + k0 * yy) + k0 * rest, syy = oedometric() * (yy + k0 * xx) + rest,
                     sxy = shear * xy;
        for (std::size_t i = 0; i < 4; ++i) {
          const Pair& d = square_.slope(q, i);
          force_[corner[i]][0] -= square_.weight() * (d[0] * sxx + d[1] * sxy);
          force_[corner[i]][1] -= square_.weight() * (d[0] * sxy + d[1] * syy);
        }
      }
    }
  }
  void meet_base(std::size_t i, double dt) {
    const double least = -moved_[i][1] / dt;  // closes the gap
    const double impulse = least - velocity_[i][1];
    if (!(impulse > 0)) return;
    velocity_[i][1] = least;
    const double speed = std::abs(velocity_[i][0]), grip = block_.friction * impulse;
    velocity_[i][0] *= speed > grip ? 1 - grip / speed : 0;
  }

  InclineBlock block_;
  Square square_;
  std::size_t along_, over_;  ///< squares; nodes run along the base first
  std::vector<double> mass_;
  std::vector<Pair> moved_, velocity_, force_;
};

}  // namespace

std::vector<BlockState> lagrangian_block_path(const InclineBlock& block, const std::vector<double>& times) {
  Body body(block);
  std::vector<BlockState> path;
  double time = 0;
  for (const double until : times) {
    const auto steps = static_cast<int>(std::ceil((until - time) / body.stable_step()));
    for (int k = 0; k < steps; ++k) body.step((until - time) / steps);
    time = until;
    path.push_back(body.state(time));
  }
  return path;
}

}  // namespace wetfront::verification
