#pragma once

#include <array>
#include <cmath>

namespace wetfront::mpm {

template <int dim>
using Vector = std::array<double, dim>;  ///< components along the axes, in the unit of what it is

template <int dim>
double dot(const Vector<dim>& a, const Vector<dim>& b) {  ///< scalar product, in the product of the units
  double sum = 0;
  for (int i = 0; i < dim; ++i) sum += a[i] * b[i];
  return sum;
}

template <int dim>
double length(const Vector<dim>& v) {  ///< Euclidean norm, in the unit of the vector
  return std::sqrt(dot<dim>(v, v));
}

}  // namespace wetfront::mpm
