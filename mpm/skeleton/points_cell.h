#pragma once

#include "mpm/skeleton/linear_shape.h"
#include "mpm/skeleton/skeleton_columns.h"

namespace wetfront::mpm {

/// How points take the motion of the nodes.
enum class Take {
  increments,  ///< dt a_i: FLIP
  blend,       ///< the same, with a share of v_i + dt a_i (PIC)
  affine,      ///< v_i + dt a_i and its gradient (APIC)
};
struct TransferParts {
  double dt;     ///< s
  double pic;    ///< share of the nodes' velocities themselves [-]
  bool back;     ///< the points' new momenta go to the nodes (MUSL)
  double light;  ///< nodal mass [kg; kg/m] below which accelerations strain less (DeformingSkeleton::strained)
};

/// III: v_p += dt sum N_i a_i (Eq. 13), with a share of sum N_i (v_i + dt a_i) (PIC), or all of that and C_p = its
/// gradient (APIC, Jiang et al. 2015: for linear functions their B D^-1 is the gradient). MUSL: momenta back to the
/// nodes (Eq. 14).
template <int dim, class Shape, Take kind>
class PointsCell {
 public:
  static constexpr int nodes = Shape::nodes;

  PointsCell(const Shape& shape, const SkeletonColumns& columns, TransferParts parts)
      : shape_(shape), point_(columns), node_(columns), parts_(parts) {}

  void fetch(std::size_t slot) const { point_.fetch_motion(slot); }
  [[gnu::always_inline]] void operator()(const Block& block) {
    shape_.enter(block);
    if (parts_.back)
      pass<true>(block);
    else
      pass<false>(block);
  }

 private:
  using Place = std::array<Lanes, dim>;
  using Nodal = std::array<typename Shape::Field, dim>;

  template <bool back>
  [[gnu::always_inline]] void pass(const Block& block) const {
    Nodal change, velocity;
    each<dim>([&](auto a) __attribute__((always_inline)) {
      change[a] = shape_.field([&](int i) __attribute__((always_inline)) {
        const int node = shape_.node(i);
        const double gain = parts_.dt * node_.acceleration[a][node];
        // What the new velocity, whose gradient points take, lacks at light nodes.
        if constexpr (kind == Take::affine) return gain * (1 - std::min(1.0, node_.mass[node] / parts_.light));
        return gain;
      });
      if constexpr (kind != Take::increments)
        velocity[a] = shape_.field([&](int i) { return node_.new_velocity[a][shape_.node(i)]; });
    });
    std::array<std::array<Lanes, nodes>, dim> momentum{};
    for (std::size_t k = 0; k < block.count; k += lane_count) {
      const std::size_t p = block.first + k;
      const LaneMask live = live_lanes(block.count - k);
      Place x, v;
      each<dim>([&](auto a) __attribute__((always_inline)) {
        x[a] = load(point_.position[a] + p);
        v[a] = load(point_.velocity[a] + p);
      });
      typename Shape::Stencil at;
      if constexpr (kind == Take::affine) {
        shape_.all(x, at);
        take_affine(velocity, at, p, live, v);
        each<dim>([&](auto a) __attribute__((always_inline)) { v[a] += shape_.value(change[a], at); });
      } else {
        shape_.values(x, at);
        take(change, velocity, at, v);
      }
      each<dim>([&](auto a) __attribute__((always_inline)) { store_live(v[a], point_.velocity[a] + p, live); });
      if constexpr (back) give(p, x, v, at, momentum);
    }
    if constexpr (back)
      each<dim>([&](auto a) __attribute__((always_inline)) {
        if constexpr (requires { shape_.add_to_nodes(Lanes{}, node_.velocity[a]); })
          shape_.add_to_nodes(sums(momentum[a][0], momentum[a][1], momentum[a][2], momentum[a][3]), node_.velocity[a]);
        else
          add_sums(momentum[a], node_.velocity[a], [this](int i) { return shape_.node(i); });
      });
  }

  [[gnu::always_inline]] void take(const Nodal& change, const Nodal& velocity, const typename Shape::Stencil& at,
                                   Place& v) const {
    each<dim>([&](auto a) __attribute__((always_inline)) {
      v[a] += shape_.value(change[a], at);
      if constexpr (kind == Take::blend) v[a] += (shape_.value(velocity[a], at) - v[a]) * parts_.pic;
    });
  }
  void take_affine(const Nodal& velocity, const typename Shape::Stencil& at, std::size_t p, const LaneMask& live,
                   Place& v) const {
    for (int a = 0; a < dim; ++a) {
      v[a] = shape_.value(velocity[a], at);
      const Place along = shape_.slopes(velocity[a], at);
      for (int d = 0; d < dim; ++d) {
        Lanes slope(0.0);
        for (int b = 0; b < dim; ++b) slope += along[b] * at.inverse[b][d];
        store_live(slope, point_.affine[a * dim + d] + p, live);
      }
    }
  }
  [[gnu::always_inline]] void give(std::size_t p, const Place& x, const Place& v, const typename Shape::Stencil& at,
                                   std::array<std::array<Lanes, nodes>, dim>& momentum) const {
    const Lanes m = load(point_.mass + p);
    each<nodes>([&](auto i) __attribute__((always_inline)) {
      const Lanes share = m * at.value[i];
      each<dim>([&](auto a) __attribute__((always_inline)) {
        Lanes u = v[a];
        if constexpr (kind == Take::affine)
          for (int b = 0; b < dim; ++b) u += load(point_.affine[a * dim + b] + p) * shape_.arm(i, b, x, at);
        momentum[a][i] += share * u;
      });
    });
  }

  Shape shape_;
  PointPlaces<dim> point_;
  NodePlaces<dim> node_;
  TransferParts parts_;
};

}  // namespace wetfront::mpm
