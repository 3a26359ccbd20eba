#pragma once

#include "mpm/skeleton/linear_shape.h"
#include "mpm/skeleton/skeleton_columns.h"

namespace wetfront::mpm {

/// How points take the motion of the nodes.
struct TransferParts {
  double dt;
  double pic;    ///< share of the nodes' velocities themselves
  bool forward;  ///< points take accelerations
  bool back;     ///< their new momenta go to the nodes (MUSL)
};

/// III: v_p += dt sum N_i a_i (Eq. 13), with a share of sum N_i (v_i + dt a_i) (PIC), or all of it and its gradient
/// (APIC: dv_p = sum N_i v_i, C_p = grad v for linear functions). MUSL: momenta back to the nodes (Eq. 14).
template <int dim, class Shape>
class PointsCell {
 public:
  static constexpr int nodes = Shape::nodes;

  PointsCell(const Shape& shape, const SkeletonColumns& columns, TransferParts parts)
      : shape_(shape), c_(columns), parts_(parts) {}

  void operator()(const Block& block) {
    shape_.enter(block);
    std::array<std::array<double, nodes>, dim> change, velocity;
    for (int a = 0; a < dim && parts_.forward; ++a)
      for (int i = 0; i < nodes; ++i) {
        change[a][i] = parts_.dt * (*c_.node_acceleration)[a][shape_.node(i)];
        velocity[a][i] = c_.node_new_velocity != nullptr ? (*c_.node_new_velocity)[a][shape_.node(i)] : 0;
      }
    std::array<std::array<Lanes, nodes>, dim> momentum{};
    typename Shape::Stencil at;
    for (std::size_t k = 0; k < block.count; k += lane_count) {
      const std::size_t p = block.first + k;
      const LaneMask live = live_lanes(block.count - k);
      Place x, v;
      for (int a = 0; a < dim; ++a) {
        x[a] = load((*c_.position)[a] + p);
        v[a] = load((*c_.velocity)[a] + p);
      }
      if (c_.affine != nullptr)
        shape_.all(x, at);
      else
        shape_.values(x, at);
      if (parts_.forward) {
        if (c_.affine != nullptr)
          take_affine(velocity, at, p, live, v);
        else
          take(change, velocity, at, v);
        for (int a = 0; a < dim; ++a) store_live(v[a], (*c_.velocity)[a] + p, live);
      }
      if (parts_.back) give(p, x, v, at, momentum);
    }
    if (!parts_.back) return;
    for (int a = 0; a < dim; ++a)
      for (int i = 0; i < nodes; ++i) (*c_.node_velocity)[a][shape_.node(i)] += sum(momentum[a][i]);
  }

 private:
  using Place = std::array<Lanes, dim>;
  using Nodal = std::array<std::array<double, nodes>, dim>;

  void take(const Nodal& change, const Nodal& velocity, const typename Shape::Stencil& at, Place& v) const {
    for (int a = 0; a < dim; ++a) {
      Lanes sum = at.value[0] * change[a][0];
      for (int i = 1; i < nodes; ++i) sum += at.value[i] * change[a][i];
      v[a] += sum;
      if (c_.node_new_velocity == nullptr) continue;
      Lanes there = at.value[0] * velocity[a][0];
      for (int i = 1; i < nodes; ++i) there += at.value[i] * velocity[a][i];
      v[a] += (there - v[a]) * parts_.pic;
    }
  }
  void take_affine(const Nodal& velocity, const typename Shape::Stencil& at, std::size_t p, const LaneMask& live,
                   Place& v) const {
    for (int a = 0; a < dim; ++a) {
      Lanes there(0.0);
      Place along{};
      for (int i = 0; i < nodes; ++i) {
        there += at.value[i] * velocity[a][i];
        for (int b = 0; b < dim; ++b) along[b] += at.slope[i][b] * velocity[a][i];
      }
      v[a] = there;
      for (int d = 0; d < dim; ++d) {
        Lanes slope(0.0);
        for (int b = 0; b < dim; ++b) slope += along[b] * at.inverse[b][d];
        store_live(slope, (*c_.affine)[a * dim + d] + p, live);
      }
    }
  }
  void give(std::size_t p, const Place& x, const Place& v, const typename Shape::Stencil& at,
            std::array<std::array<Lanes, nodes>, dim>& momentum) const {
    const Lanes m = load((*c_.mass)[0] + p);
    for (int i = 0; i < nodes; ++i) {
      const Lanes share = m * at.value[i];
      for (int a = 0; a < dim; ++a) {
        Lanes u = v[a];
        if (c_.affine != nullptr)
          for (int b = 0; b < dim; ++b) u += load((*c_.affine)[a * dim + b] + p) * shape_.arm(i, b, x, at);
        momentum[a][i] += share * u;
      }
    }
  }

  Shape shape_;
  const SkeletonColumns& c_;
  TransferParts parts_;
};

}  // namespace wetfront::mpm
