#pragma once

#include "mpm/skeleton/linear_shape.h"
#include "mpm/skeleton/skeleton_columns.h"

namespace wetfront::mpm {

/// What of a cell goes to the nodes.
struct GatherParts {
  bool motion;  ///< mass and momentum
  bool force;   ///< internal force
  bool b_bar;
  const double* covered = nullptr;  ///< per cell: volume of cells inside the body, else 0; null: no mixed integration
};

/// I, II: m_i = sum m_p N_i, momenta sum m_p (v_p + C_p (x_i - x_p)) N_i, internal forces
///   f_i = - sum_p V_p (sigma'_p grad N_i + s_p (mean grad N_i - grad N_i)),  s = tr(sigma')/3,
/// mean over the cell (B-bar; without it the second part is missing). In cells inside the body the mean stress of the
/// points acts on the cell's own volume, and only what differs from it on the points' (mixed integration, README.md).
/// Summed per cell, then added to the nodes. `apic`: points have an affine velocity C.
template <int dim, class Shape, bool apic>
class GatherCell {
 public:
  static constexpr int nodes = Shape::nodes;

  GatherCell(const Shape& shape, const SkeletonColumns& columns, GatherParts parts)
      : shape_(shape), point_(columns), node_(columns), parts_(parts) {}

  void operator()(const Block& block) {
    shape_.enter(block);
    if (parts_.motion && parts_.force)
      sum_up<true, true>(block);
    else if (parts_.motion)
      sum_up<true, false>(block);
    else
      sum_up<false, true>(block);
  }

 private:
  using Place = std::array<Lanes, dim>;
  using Nodal = std::array<Lanes, nodes>;

  /// Place of component (a, b) in the stored tensor.
  static constexpr int entry(int a, int b) { return a == b ? a : a + b == 1 ? 3 : a + b == 3 ? 4 : 5; }

  /// What acts through the mean gradients of a cell.
  struct Mean {
    std::array<double, stress_components<dim>> stress{};  ///< of the points of a covered cell, else 0
    double volume = 0;                                    ///< on which it acts
  };

  Mean mean_of(const Block& block) const {
    Mean mean;
    const double own = parts_.covered != nullptr ? parts_.covered[block.cell] : 0;
    if (own == 0) return mean;
    Lanes volume(0.0);
    std::array<Lanes, stress_components<dim>> stress{};
    for (std::size_t p = block.first; p < block.first + block.count; p += lane_count) {
      const Lanes v = load(point_.volume + p);
      volume += v;
      each<stress_components<dim>>([&](auto q)
                                       __attribute__((always_inline)) { stress[q] += v * load(point_.stress[q] + p); });
    }
    const double points = sum(volume);
    each<stress_components<dim>>([&](auto q)
                                     __attribute__((always_inline)) { mean.stress[q] = sum(stress[q]) / points; });
    mean.volume = own;
    return mean;
  }

  template <bool motion, bool force>
  [[gnu::always_inline]] void sum_up(const Block& block) const {
    Nodal mass{};
    std::array<Nodal, dim> momentum{}, pull{};
    Lanes spherical(0.0);
    Mean mean;
    if constexpr (force) mean = mean_of(block);
    for (std::size_t p = block.first; p < block.first + block.count; p += lane_count) {
      Place x;
      each<dim>([&](auto a) __attribute__((always_inline)) { x[a] = load(point_.position[a] + p); });
      typename Shape::Stencil at;
      if constexpr (force)
        shape_.all(x, at);
      else
        shape_.values(x, at);
      if constexpr (motion) add_motion(p, x, at, mass, momentum);
      if constexpr (force) add_force(p, at, mean, pull, spherical);
    }
    const auto node = [this](int i) { return shape_.node(i); };
    if constexpr (motion) add_sums(mass, node_.mass, node);
    each<dim>([&](auto a) __attribute__((always_inline)) {
      if constexpr (motion) add_sums(momentum[a], node_.velocity[a], node);
      if constexpr (force) add_sums(pull[a], node_.force[a], node);
    });
    if constexpr (force)
      if (parts_.b_bar || mean.volume > 0) add_mean(mean, sum(spherical));
  }

  /// What acts through the mean gradients: the points' own mean stresses (B-bar) and that of the cell.
  [[gnu::always_inline]] void add_mean(const Mean& mean, double spherical) const {
    std::array<Vector<dim>, nodes> gradient;
    shape_.mean_gradients(gradient);
    std::array<std::array<double, dim>, dim> stress;
    for (int a = 0; a < dim; ++a)
      for (int b = 0; b < dim; ++b)
        stress[a][b] = mean.volume * mean.stress[static_cast<std::size_t>(entry(a, b))] + (a == b ? spherical : 0.0);
    each<nodes>([&](auto i) __attribute__((always_inline)) {
      for (int a = 0; a < dim; ++a) {
        double pull = 0;
        for (int b = 0; b < dim; ++b) pull += stress[a][b] * gradient[i][b];
        node_.force[a][shape_.node(i)] -= pull;
      }
    });
  }

  [[gnu::always_inline]] void add_motion(std::size_t p, const Place& x, const typename Shape::Stencil& at, Nodal& mass,
                                         std::array<Nodal, dim>& momentum) const {
    const Lanes m = load(point_.mass + p);
    Place v;
    each<dim>([&](auto a) __attribute__((always_inline)) { v[a] = load(point_.velocity[a] + p); });
    each<nodes>([&](auto i) __attribute__((always_inline)) {
      const Lanes share = m * at.value[i];
      mass[i] += share;
      each<dim>([&](auto a) __attribute__((always_inline)) {
        if constexpr (apic) {
          Lanes u = v[a];
          for (int b = 0; b < dim; ++b) u += load(point_.affine[a * dim + b] + p) * shape_.arm(i, b, x, at);
          momentum[a][i] += share * u;
        } else {
          momentum[a][i] += share * v[a];
        }
      });
    });
  }

  [[gnu::always_inline]] void add_force(std::size_t p, const typename Shape::Stencil& at, const Mean& cell,
                                        std::array<Nodal, dim>& pull, Lanes& spherical) const {
    const Lanes volume = load(point_.volume + p);
    std::array<Lanes, stress_components<dim>> s;
    each<stress_components<dim>>([&](auto q) __attribute__((always_inline)) {
      s[q] = volume * (load(point_.stress[q] + p) - cell.stress[q]);
    });
    if (parts_.b_bar) {
      const Lanes mean = (s[0] + s[1] + s[2]) * (1.0 / 3);
      spherical += mean;
      each<dim>([&](auto q) __attribute__((always_inline)) { s[q] -= mean; });
    }
    each<dim>([&](auto a) __attribute__((always_inline)) {
      Place along;  // V sigma' along the local axes
      each<dim>([&](auto b) __attribute__((always_inline)) {
        along[b] = s[entry(a, 0)] * at.inverse[b][0];
        each<dim - 1>([&](auto d)
                          __attribute__((always_inline)) { along[b] += s[entry(a, d + 1)] * at.inverse[b][d + 1]; });
      });
      each<nodes>([&](auto i) __attribute__((always_inline)) {
        each<dim>([&](auto b) __attribute__((always_inline)) { pull[a][i] -= along[b] * at.slope[i][b]; });
      });
    });
  }

  Shape shape_;
  PointPlaces<dim> point_;
  NodePlaces<dim> node_;
  GatherParts parts_;
};

}  // namespace wetfront::mpm
