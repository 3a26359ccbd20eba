#pragma once

#include "mpm/grid/spline_grid.h"
#include "mpm/skeleton/linear_shape.h"

namespace wetfront::mpm {

/// Quadratic B-splines for the points of one cell, four at a time (SplineGrid).
template <int dim>
class SplineShape {
 public:
  static constexpr int nodes = SplineGrid<dim>::nodes;
  using Stencil = LaneStencil<dim, nodes>;
  using Place = std::array<Lanes, dim>;

  explicit SplineShape(const SplineGrid<dim>& splines) : splines_(splines) {}

  void enter(const Block& block) {
    splines_.nodes_of(block.cell, node_.data());
    corner_ = splines_.corner(block.cell);
    for (int a = 0; a < dim; ++a) {
      axis_[a] = splines_.axis(block.cell, a);
      inverse_[a] = 1 / splines_.spacing(a);
    }
  }
  int node(int i) const { return node_[i]; }

  void mean_gradients(std::array<Vector<dim>, nodes>& mean) const {
    for (int i = 0; i < nodes; ++i)
      for (int a = 0; a < dim; ++a) {
        mean[i][a] = inverse_[a];
        for (int b = 0; b < dim; ++b) {
          const auto& c = axis_[b][of(i, b)];
          mean[i][a] *= b == a ? c[1] + c[2] : c[0] + c[1] / 2 + c[2] / 3;
        }
      }
  }

  [[gnu::always_inline]] Place local(const Place& x) const {
    Place t;
    for (int a = 0; a < dim; ++a) t[a] = (x[a] - corner_[a]) * inverse_[a];
    return t;
  }
  [[gnu::always_inline]] LaneMask outside(const Place& x) const {
    const Place t = local(x);
    constexpr double border = 0.5e-10;  // as Grid::find_cell
    LaneMask out = t[0] < -border || t[0] > 1 + border;
    for (int b = 1; b < dim; ++b) out = out || t[b] < -border || t[b] > 1 + border;
    return out;
  }
  /// As LinearShape's: a nodal quantity and its values and slopes at the points.
  struct Field {
    std::array<double, nodes> at_node;
  };
  template <class At>
  Field field(const At& at_node) const {
    Field f;
    for (int i = 0; i < nodes; ++i) f.at_node[i] = at_node(i);
    return f;
  }
  static Lanes value(const Field& f, const Stencil& at) {
    Lanes out = at.value[0] * f.at_node[0];
    for (int i = 1; i < nodes; ++i) out += at.value[i] * f.at_node[i];
    return out;
  }
  static Place slopes(const Field& f, const Stencil& at) {
    Place out;
    for (int b = 0; b < dim; ++b) {
      out[b] = at.slope[0][b] * f.at_node[0];
      for (int i = 1; i < nodes; ++i) out[b] += at.slope[i][b] * f.at_node[i];
    }
    return out;
  }
  double mean_divergence(const std::array<Field, dim>& f) const {
    std::array<Vector<dim>, nodes> mean;
    mean_gradients(mean);
    double sum = 0;
    for (int i = 0; i < nodes; ++i)
      for (int a = 0; a < dim; ++a) sum += mean[i][a] * f[a].at_node[i];
    return sum;
  }
  void places(const Place& x, Stencil& at) const { values(x, at); }
  void map(const Place& x, Stencil& at) const { all(x, at); }
  void values(const Place& x, Stencil& at) const {
    at.local = local(x);
    Factors value;
    for (int a = 0; a < dim; ++a)
      for (std::size_t k = 0; k < 3; ++k) value[a][k] = polynomial(axis_[a][k], at.local[a]);
    for (int i = 0; i < nodes; ++i) {
      at.value[i] = value[0][of(i, 0)];
      for (int a = 1; a < dim; ++a) at.value[i] *= value[a][of(i, a)];
    }
  }
  void all(const Place& x, Stencil& at) const {
    at.local = local(x);
    Factors value, slope;
    for (int a = 0; a < dim; ++a)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& c = axis_[a][k];
        value[a][k] = polynomial(c, at.local[a]);
        slope[a][k] = at.local[a] * (2 * c[2]) + c[1];
      }
    for (int i = 0; i < nodes; ++i) {
      at.value[i] = value[0][of(i, 0)];
      for (int a = 1; a < dim; ++a) at.value[i] *= value[a][of(i, a)];
      for (int b = 0; b < dim; ++b) {
        at.slope[i][b] = slope[b][of(i, b)];
        for (int a = 0; a < dim; ++a)
          if (a != b) at.slope[i][b] *= value[a][of(i, a)];
      }
    }
    for (int b = 0; b < dim; ++b)
      for (int a = 0; a < dim; ++a) at.inverse[b][a] = Lanes(a == b ? inverse_[a] : 0.0);
  }
  Lanes arm(int i, int axis, const Place& x, const Stencil&) const { return splines_.place(node_[i])[axis] - x[axis]; }

 private:
  using Factors = std::array<std::array<Lanes, 3>, dim>;
  static constexpr std::size_t of(int i, int axis) {
    return static_cast<std::size_t>(axis == 0 ? i % 3 : axis == 1 ? i / 3 % 3 : i / 9);
  }
  static Lanes polynomial(const std::array<double, 3>& c, const Lanes& t) { return (t * c[2] + c[1]) * t + c[0]; }

  const SplineGrid<dim>& splines_;
  std::array<int, nodes> node_{};
  Vector<dim> corner_{}, inverse_{};
  std::array<typename SplineGrid<dim>::Axis, dim> axis_{};
};

}  // namespace wetfront::mpm
