#pragma once

#include "mpm/grid/stencil.h"

#include <array>

namespace wetfront::mpm {

/// Sums over the points of a cell, sum w N_i and sum w dN_i/dxi for all its nodes, by the moments of w: N_i is a
/// polynomial of one factor per axis, so a point costs 2^dim products instead of every node's function and gradient.
template <int dim>
class CellMoments {
 public:
  void add(const Vector<dim>& xi, double w) {
    std::array<double, terms> product;
    product[0] = w;
    for (int a = 0; a < dim; ++a)
      for (int m = 0; m < 1 << a; ++m) product[m + (1 << a)] = product[m] * xi[a];
    for (int m = 0; m < terms; ++m) moment_[m] += product[m];
  }

  double value(int node) const {
    double sum = 0;
    for (int m = 0; m < terms; ++m) sum += sign(node, m) * moment_[m];
    return sum / terms;
  }
  /// By local coordinates.
  Vector<dim> slope(int node) const {
    Vector<dim> sum{};
    for (int a = 0; a < dim; ++a)
      for (int m = 0; m < terms; ++m)
        if ((m & 1 << a) == 0) sum[a] += sign(node, m + (1 << a)) * moment_[m] / terms;
    return sum;
  }

 private:
  static constexpr int terms = 1 << dim;

  static constexpr double sign(int node, int m) {
    double product = 1;
    for (int a = 0; a < dim; ++a)
      if ((m & 1 << a) != 0) product *= node_sign(node, a);
    return product;
  }

  std::array<double, terms> moment_{};  ///< of w times the coordinates of the axes in the bits of the index
};

}  // namespace wetfront::mpm
