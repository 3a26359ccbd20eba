#pragma once

#include "mpm/grid/vector.h"

#include <array>
#include <cstddef>

/// Linear shape functions of quadrilaterals and hexahedra in gmsh's node order.
namespace wetfront::mpm {

template <int dim>
constexpr int cell_nodes = 1 << dim;

/// Shape functions and their gradients at one place of a cell.
template <int dim>
struct Stencil {
  std::array<double, cell_nodes<dim>> value{};          ///< N_i [-]
  std::array<Vector<dim>, cell_nodes<dim>> gradient{};  ///< dN_i/dx [1/m]
};

/// Local coordinate (+1 or -1) of node i along an axis: counter-clockwise in the plane, then up.
constexpr double node_sign(int node, int axis) {
  const int in_plane = node % 4;
  if (axis == 0) return in_plane == 1 || in_plane == 2 ? 1.0 : -1.0;
  if (axis == 1) return in_plane >= 2 ? 1.0 : -1.0;
  return node >= 4 ? 1.0 : -1.0;
}

/// N_i at local coordinates xi in [-1, 1]^dim, and dN_i/dxi.
template <int dim>
void reference_stencil(const Vector<dim>& xi, Stencil<dim>& out) {
  for (int i = 0; i < cell_nodes<dim>; ++i) {
    double value = 1;
    Vector<dim> factor{};
    for (int a = 0; a < dim; ++a) {
      factor[a] = 0.5 * (1 + node_sign(i, a) * xi[a]);
      value *= factor[a];
    }
    out.value[i] = value;
    for (int a = 0; a < dim; ++a) {
      double slope = 0.5 * node_sign(i, a);
      for (int b = 0; b < dim; ++b)
        if (b != a) slope *= factor[b];
      out.gradient[i][a] = slope;
    }
  }
}

}  // namespace wetfront::mpm
