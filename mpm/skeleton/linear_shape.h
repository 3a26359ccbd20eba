#pragma once

#include "mpm/grid/cell_integrals.h"
#include "mpm/grid/material_points.h"
#include "mpm/lanes.h"
#include "mpm/skeleton/cell_nodes.h"

namespace wetfront::mpm {

/// Four points in a cell: shape functions, their slopes along the local axes, and the map.
template <int dim, int nodes>
struct LaneStencil {
  std::array<Lanes, dim> local;                     ///< u in [0, 1] inside the cell
  std::array<Lanes, nodes> value;                   ///< N_i [-]
  std::array<std::array<Lanes, dim>, nodes> slope;  ///< dN_i/du_b [-]
  std::array<std::array<Lanes, dim>, dim> inverse;  ///< [b][a] = du_b/dx_a [1/m]
};

/// Shape functions of quadrilaterals and hexahedra for the points of one cell, four at a time. Affine cells take one
/// matrix product, others Newton's method in lanes.
template <int dim>
class LinearShape {
 public:
  static constexpr int nodes = cell_nodes<dim>;
  using Stencil = LaneStencil<dim, nodes>;
  using Place = std::array<Lanes, dim>;

  explicit LinearShape(const Grid<dim>& grid) : grid_(grid) {}

  [[gnu::always_inline]] void enter(const Block& block) {
    cell_ = block.cell;
    node_ = block.nodes;
    affine_ = grid_.affine(cell_);
    at_nodes_ = CellNodes<dim>(node_);
    const auto& map = grid_.map(cell_);
    for (int b = 0; b < dim; ++b) {
      centre_[b] = map.centre[b];
      for (int a = 0; a < dim; ++a) inverse_[b][a] = 0.5 * map.inverse[b][a];
    }
  }
  int node(int i) const { return node_[i]; }
  bool affine() const { return affine_; }
  /// du_b/dx_a [1/m]: of an affine cell everywhere, of others at the centre.
  double inverse(int b, int a) const { return inverse_[b][a]; }

  /// A nodal quantity f as a polynomial of the local coordinates, ready for the points of the cell:
  ///   f = (c0 + c1 u + c2 v + c3 u v) + w (c4 + c5 u + c6 v + c7 u v).
  /// A quantity that all nodes share is that at the points too, to the last bit.
  struct Field {
    std::array<double, nodes> c;
  };
  template <class At>
  [[gnu::always_inline]] Field field(const At& at_node) const {
    Field f;
    for (int k = 0; k < nodes; k += 4) {
      const double f0 = at_node(k), f1 = at_node(k + 1), f2 = at_node(k + 2), f3 = at_node(k + 3);
      f.c[k] = f0, f.c[k + 1] = f1 - f0, f.c[k + 2] = f3 - f0, f.c[k + 3] = (f2 - f1) - (f3 - f0);
    }
    if constexpr (dim == 3)
      for (int k = 0; k < 4; ++k) f.c[k + 4] -= f.c[k];
    return f;
  }
  [[gnu::always_inline]] static Lanes value(const Field& f, const Stencil& at) {
    Lanes out = in_plane(f, 0, at.local);
    if constexpr (dim == 3) out += in_plane(f, 4, at.local) * at.local[2];
    return out;
  }
  /// df/du_b.
  [[gnu::always_inline]] static Place slopes(const Field& f, const Stencil& at) {
    const Place& u = at.local;
    Place out;
    out[0] = u[1] * f.c[3] + f.c[1];
    out[1] = u[0] * f.c[3] + f.c[2];
    if constexpr (dim == 3) {
      out[0] += (u[1] * f.c[7] + f.c[5]) * u[2];
      out[1] += (u[0] * f.c[7] + f.c[6]) * u[2];
      out[2] = in_plane(f, 4, u);
    }
    return out;
  }

  /// Mean over the cell of dN_i/dx_a.
  void mean_gradients(std::array<Vector<dim>, nodes>& mean) const {
    if (!affine_) {
      mean = mpm::mean_gradients(grid_, cell_);
      return;
    }
    for (int i = 0; i < nodes; ++i)
      for (int a = 0; a < dim; ++a) {
        mean[i][a] = 0;
        for (int b = 0; b < dim; ++b) mean[i][a] += inverse_[b][a] * (node_sign(i, b) * (2.0 / nodes));
      }
  }

  /// Mean over the cell of sum_a df_a/dx_a.
  [[gnu::always_inline]] double mean_divergence(const std::array<Field, dim>& f) const {
    if (!affine_) return crooked_divergence(grid_, cell_, f);
    double sum = 0;
    for (int a = 0; a < dim; ++a) {
      const auto& c = f[a].c;
      double along[dim] = {c[1] + 0.5 * c[3], c[2] + 0.5 * c[3]};
      if constexpr (dim == 3) {
        along[0] += 0.5 * (c[5] + 0.5 * c[7]), along[1] += 0.5 * (c[6] + 0.5 * c[7]);
        along[2] = c[4] + 0.5 * (c[5] + c[6] + 0.5 * c[7]);
      }
      for (int b = 0; b < dim; ++b) sum += inverse_[b][a] * along[b];
    }
    return sum;
  }

  /// The same with the nodes of a quadrilateral in lanes.
  [[gnu::always_inline]] std::array<Lanes, 2> mean_gradients() const requires(dim == 2) {
    alignas(32) static constexpr double sign[2][4] = {{-0.5, 0.5, 0.5, -0.5}, {-0.5, -0.5, 0.5, 0.5}};
    if (!affine_) return crooked_mean_gradients(grid_, cell_);
    const Lanes along0 = load(sign[0]), along1 = load(sign[1]);
    return {along0 * inverse_[0][0] + along1 * inverse_[1][0], along0 * inverse_[0][1] + along1 * inverse_[1][1]};
  }
  /// Adds a number for each node of a quadrilateral to its entry of a column.
  [[gnu::always_inline]] void add_to_nodes(const Lanes& value, double* to) const requires(dim == 2) {
    at_nodes_.add({value}, to);
  }

  [[gnu::always_inline]] Place local(const Place& x) const {
    Place arm, u;
    each<dim>([&](auto a) __attribute__((always_inline)) { arm[a] = x[a] - centre_[a]; });
    each<dim>([&](auto b) __attribute__((always_inline)) {
      u[b] = arm[0] * inverse_[b][0] + 0.5;
      for (int a = 1; a < dim; ++a) u[b] += arm[a] * inverse_[b][a];
    });
    if (!affine_) u = crooked_local(grid_, node_, x, u);
    return u;
  }
  [[gnu::always_inline]] LaneMask outside(const Place& x) const {
    const Place u = local(x);
    constexpr double border = 0.5e-10;  // as Grid::find_cell
    LaneMask out = u[0] < -border || u[0] > 1 + border;
    for (int b = 1; b < dim; ++b) out = out || u[b] < -border || u[b] > 1 + border;
    return out;
  }
  /// The local coordinates only; `value` of a field needs no more.
  [[gnu::always_inline]] void places(const Place& x, Stencil& at) const { at.local = local(x); }
  /// And the map; `slopes` of a field and `inverse` are its gradient.
  [[gnu::always_inline]] void map(const Place& x, Stencil& at) const {
    at.local = local(x);
    each<dim>([&](auto b) __attribute__((always_inline)) {
      for (int a = 0; a < dim; ++a) at.inverse[b][a] = Lanes(inverse_[b][a]);
    });
    if (!affine_) at.inverse = crooked_inverse_at(grid_, node_, at.local);
  }
  /// Values only.
  [[gnu::always_inline]] void values(const Place& x, Stencil& at) const {
    at.local = local(x);
    set_values(at);
  }
  [[gnu::always_inline]] void all(const Place& x, Stencil& at) const {
    at.local = local(x);
    set_values(at);
    set_slopes(at);
    each<dim>([&](auto b) __attribute__((always_inline)) {
      for (int a = 0; a < dim; ++a) at.inverse[b][a] = Lanes(inverse_[b][a]);
    });
    if (!affine_) at.inverse = crooked_inverse(grid_, node_, at.slope);
  }
  /// Place of node i less the points' [m], for affine velocities.
  [[gnu::always_inline]] Lanes arm(int i, int axis, const Place& x, const Stencil&) const {
    return grid_.node(node_[i])[axis] - x[axis];
  }

 private:
  [[gnu::always_inline]] static Lanes in_plane(const Field& f, int k, const Place& u) {
    return (u[0] * f.c[k + 3] + f.c[k + 2]) * u[1] + (u[0] * f.c[k + 1] + f.c[k]);
  }
  static constexpr bool upper(int i, int axis) { return node_sign(i, axis) > 0; }

  [[gnu::always_inline]] static void set_values(Stencil& at) {
    std::array<Lanes, dim> other;
    each<dim>([&](auto a) __attribute__((always_inline)) { other[a] = 1.0 - at.local[a]; });
    each<nodes>([&](auto i) __attribute__((always_inline)) {
      at.value[i] = upper(i, 0) ? at.local[0] : other[0];
      each<dim - 1>([&](auto b) __attribute__((always_inline)) {
        at.value[i] *= upper(i, b + 1) ? at.local[b + 1] : other[b + 1];
      });
    });
  }
  [[gnu::always_inline]] static void set_slopes(Stencil& at) {
    std::array<Lanes, dim> other;
    each<dim>([&](auto a) __attribute__((always_inline)) { other[a] = 1.0 - at.local[a]; });
    const auto factor = [&](int i, int a) __attribute__((always_inline)) {
      return upper(i, a) ? at.local[a] : other[a];
    };
    each<nodes>([&](auto i) __attribute__((always_inline)) {
      each<dim>([&](auto b) __attribute__((always_inline)) {
        Lanes product = factor(i, (b + 1) % dim);
        if constexpr (dim == 3) product *= factor(i, (b + 2) % dim);
        at.slope[i][b] = upper(i, b) ? product : -product;
      });
    });
  }
  using Matrix = std::array<std::array<Lanes, dim>, dim>;
  /// The inverse of J[a][b] = dx_a/du_b. (What crooked cells need is called, not inlined, passed by value and knows no
  /// `this`: the affine path keeps its numbers in registers.)
  [[gnu::noinline]] static Matrix crooked_inverse(const Grid<dim>& grid, const int* node,
                                                  std::array<std::array<Lanes, dim>, nodes> slope) {
    Matrix jacobian{};
    for (int i = 0; i < nodes; ++i)
      for (int a = 0; a < dim; ++a)
        for (int b = 0; b < dim; ++b) jacobian[a][b] += grid.node(node[i])[a] * slope[i][b];
    return inverse_of(jacobian);
  }
  [[gnu::noinline]] static std::array<Lanes, 2> crooked_mean_gradients(const Grid<dim>& grid, std::size_t cell) {
    const auto mean = mpm::mean_gradients(grid, cell);
    std::array<Lanes, 2> out;
    for (int i = 0; i < 4; ++i)
      for (int a = 0; a < 2; ++a) out[a][static_cast<std::size_t>(i)] = mean[i][a];
    return out;
  }
  [[gnu::noinline]] static double crooked_divergence(const Grid<dim>& grid, std::size_t cell,
                                                     std::array<Field, dim> f) {
    const auto mean = mpm::mean_gradients(grid, cell);
    double sum = 0;
    for (int a = 0; a < dim; ++a)
      for (int i = 0; i < nodes; ++i) {
        double at_node = 0;
        for (int k = 0; k < nodes; ++k) at_node += (belongs(k, i) ? f[a].c[k] : 0.0);
        sum += mean[i][a] * at_node;
      }
    return sum;
  }
  /// The term k of a field counts at node i.
  static constexpr bool belongs(int k, int i) {
    return (k % 2 == 0 || upper(i, 0)) && (k / 2 % 2 == 0 || upper(i, 1)) && (k < 4 || upper(i, 2));
  }
  [[gnu::noinline]] static Matrix crooked_inverse_at(const Grid<dim>& grid, const int* node, Place u) {
    Stencil at;
    at.local = u;
    set_slopes(at);
    return crooked_inverse(grid, node, at.slope);
  }
  /// Newton's method from the affine guess; quadratic, a convex cell never needs 20 steps. Lanes far outside (dead
  /// slots, points about to be held) are kept within three cells. A lane that has arrived stays: how long others, dead
  /// ones even, have to go on must not show in its bits.
  [[gnu::noinline]] static Place crooked_local(const Grid<dim>& grid, const int* node, Place x, Place u) {
    Stencil at;
    LaneMask moving(true);
    for (int iteration = 0; iteration < 20 && any(moving); ++iteration) {
      for (Lanes& c : u) c = max(min(c, Lanes(2.0)), Lanes(-1.0));
      at.local = u;
      set_values(at);
      set_slopes(at);
      at.inverse = crooked_inverse(grid, node, at.slope);
      Place miss = x;
      for (int i = 0; i < nodes; ++i)
        for (int a = 0; a < dim; ++a) miss[a] -= at.value[i] * grid.node(node[i])[a];
      LaneMask far(false);
      for (int b = 0; b < dim; ++b) {
        Lanes step = at.inverse[b][0] * miss[0];
        for (int a = 1; a < dim; ++a) step += at.inverse[b][a] * miss[a];
        u[b] = select(moving, u[b] + step, u[b]);
        far = far || abs(step) > 5e-15;
      }
      moving = moving && far;
    }
    return u;
  }
  static Matrix inverse_of(const Matrix& m) {
    Matrix out;
    if constexpr (dim == 2) {
      const Lanes scale = 1.0 / (m[0][0] * m[1][1] - m[0][1] * m[1][0]);
      out = {{{m[1][1] * scale, -m[0][1] * scale}, {-m[1][0] * scale, m[0][0] * scale}}};
    } else {
      const auto cofactor = [&m](int r, int c) {
        const int r0 = (r + 1) % 3, r1 = (r + 2) % 3, c0 = (c + 1) % 3, c1 = (c + 2) % 3;
        return m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0];
      };
      const Lanes scale = 1.0 / (m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2));
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) out[c][r] = cofactor(r, c) * scale;
    }
    return out;
  }

  const Grid<dim>& grid_;
  std::size_t cell_ = 0;
  const int* node_ = nullptr;
  bool affine_ = true;
  CellNodes<dim> at_nodes_;
  Vector<dim> centre_{};
  std::array<Vector<dim>, dim> inverse_{};  ///< du/dx
};

}  // namespace wetfront::mpm
