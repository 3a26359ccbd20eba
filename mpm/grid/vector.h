#pragma once

#include <array>
#include <cmath>

namespace wetfront::mpm {

template <int dim>
using Vector = std::array<double, dim>;

template <int dim>
double dot(const Vector<dim>& a, const Vector<dim>& b) {
  double sum = 0;
  for (int i = 0; i < dim; ++i) sum += a[i] * b[i];
  return sum;
}

template <int dim>
double length(const Vector<dim>& v) {
  return std::sqrt(dot<dim>(v, v));
}

}  // namespace wetfront::mpm
