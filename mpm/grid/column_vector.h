#pragma once

#include "meshes/mesh.h"
#include "mpm/grid/vector.h"
#include "mpm/plan/column.h"

/// A vector of a column, component by component.
namespace wetfront::mpm {

template <int dim>
Vector<dim> at(const Column& column, std::size_t i) {
  Vector<dim> v{};
  for (int a = 0; a < dim; ++a) v[a] = column[a][i];
  return v;
}

template <int dim>
void put(Column& column, std::size_t i, const Vector<dim>& v) {
  for (int a = 0; a < dim; ++a) column[a][i] = v[a];
}

/// As others keep places: with a third coordinate, which is 0 in the plane.
template <int dim>
meshes::Point point_of(const Vector<dim>& v) {
  meshes::Point point{};
  for (int a = 0; a < dim; ++a) point[static_cast<std::size_t>(a)] = v[a];
  return point;
}

/// Its components, one array per axis.
template <int dim>
std::array<double*, dim> axes(Column& column) {
  std::array<double*, dim> out;
  for (int a = 0; a < dim; ++a) out[a] = column[a];
  return out;
}

}  // namespace wetfront::mpm
