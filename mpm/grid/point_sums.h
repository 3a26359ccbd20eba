#pragma once

#include "mpm/grid/column_vector.h"
#include "mpm/grid/material_points.h"

namespace wetfront::mpm {

/// Sum of value(slot) over the live points, block by block.
template <int dim, class Value>
double over_points(const MaterialPoints<dim>& points, const Value& value) {
  double sum = 0;
  for (const Block& block : points.blocks())
    for (std::size_t p = block.first; p < block.first + block.count; ++p) sum += value(p);
  return sum;
}

/// Sum of m v^2/2 over the points [J].
template <int dim>
double kinetic_energy(const MaterialPoints<dim>& points, const Column& mass, const Column& velocity) {
  return over_points(points, [&](std::size_t p) {
    const Vector<dim> v = at<dim>(velocity, p);
    return 0.5 * mass[0][p] * dot<dim>(v, v);
  });
}

}  // namespace wetfront::mpm
