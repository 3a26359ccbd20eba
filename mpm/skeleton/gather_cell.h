#pragma once

#include "mpm/skeleton/linear_shape.h"
#include "mpm/skeleton/skeleton_columns.h"

namespace wetfront::mpm {

/// What of a cell goes to the nodes.
struct GatherParts {
  bool motion;  ///< mass and momentum
  bool force;   ///< internal force
  bool b_bar;
};

/// I, II: m_i = sum m_p N_i, momenta sum m_p (v_p + C_p (x_i - x_p)) N_i, internal forces
///   f_i = - sum_p V_p (sigma'_p grad N_i + s_p (mean grad N_i - grad N_i)),  s = tr(sigma')/3,
/// mean over the cell (B-bar; without it the second part is missing). Summed per cell, then added to the nodes.
template <int dim, class Shape>
class GatherCell {
 public:
  static constexpr int nodes = Shape::nodes;

  GatherCell(const Shape& shape, const SkeletonColumns& columns, GatherParts parts)
      : shape_(shape), c_(columns), parts_(parts) {}

  void operator()(const Block& block) {
    shape_.enter(block);
    if (parts_.motion) motion(block);
    if (parts_.force) force(block);
  }

 private:
  using Place = std::array<Lanes, dim>;
  static Place place(const Column& position, std::size_t p) {
    Place x;
    for (int a = 0; a < dim; ++a) x[a] = load(position[a] + p);
    return x;
  }

  void motion(const Block& block) {
    std::array<Lanes, nodes> mass{};
    std::array<std::array<Lanes, nodes>, dim> momentum{};
    typename Shape::Stencil at;
    for (std::size_t k = 0; k < block.count; k += lane_count) {
      const std::size_t p = block.first + k;
      const Place x = place(*c_.position, p);
      shape_.values(x, at);
      const Lanes m = load((*c_.mass)[0] + p);
      Place v;
      for (int a = 0; a < dim; ++a) v[a] = load((*c_.velocity)[a] + p);
      for (int i = 0; i < nodes; ++i) {
        const Lanes share = m * at.value[i];
        mass[i] += share;
        for (int a = 0; a < dim; ++a) momentum[a][i] += share * (c_.affine ? v[a] + spin(a, i, p, x, at) : v[a]);
      }
    }
    add(mass, (*c_.node_mass)[0]);
    for (int a = 0; a < dim; ++a) add(momentum[a], (*c_.node_velocity)[a]);
  }

  Lanes spin(int a, int i, std::size_t p, const Place& x, const typename Shape::Stencil& at) const {
    Lanes sum(0.0);
    for (int b = 0; b < dim; ++b) sum += load((*c_.affine)[a * dim + b] + p) * shape_.arm(i, b, x, at);
    return sum;
  }

  void force(const Block& block) {
    static constexpr int of[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};  // place of (a, b) in the stored tensor
    std::array<std::array<Lanes, nodes>, dim> force{};
    Lanes spherical(0.0);
    typename Shape::Stencil at;
    for (std::size_t k = 0; k < block.count; k += lane_count) {
      const std::size_t p = block.first + k;
      shape_.all(place(*c_.position, p), at);
      const Lanes volume = load((*c_.volume)[0] + p);
      std::array<Lanes, stress_components<dim>> s;
      for (int q = 0; q < stress_components<dim>; ++q) s[q] = volume * load((*c_.stress)[q] + p);
      if (parts_.b_bar) {
        const Lanes mean = (s[0] + s[1] + s[2]) * (1.0 / 3);
        spherical += mean;
        for (int q = 0; q < dim; ++q) s[q] -= mean;
      }
      for (int a = 0; a < dim; ++a) {
        std::array<Lanes, dim> along;  // V sigma' along the local axes
        for (int b = 0; b < dim; ++b) {
          along[b] = s[of[a][0]] * at.inverse[b][0];
          for (int d = 1; d < dim; ++d) along[b] += s[of[a][d]] * at.inverse[b][d];
        }
        for (int i = 0; i < nodes; ++i)
          for (int b = 0; b < dim; ++b) force[a][i] -= along[b] * at.slope[i][b];
      }
    }
    for (int a = 0; a < dim; ++a) add(force[a], (*c_.node_force)[a]);
    if (!parts_.b_bar) return;
    const double whole = sum(spherical);
    std::array<Vector<dim>, nodes> mean;
    shape_.mean_gradients(mean);
    for (int i = 0; i < nodes; ++i)
      for (int a = 0; a < dim; ++a) (*c_.node_force)[a][shape_.node(i)] -= whole * mean[i][a];
  }

  void add(const std::array<Lanes, nodes>& values, double* to) const {
    for (int i = 0; i < nodes; ++i) to[shape_.node(i)] += sum(values[i]);
  }

  Shape shape_;
  const SkeletonColumns& c_;
  GatherParts parts_;
};

}  // namespace wetfront::mpm
