#include "mpm/grid/seeding.h"

#include "mpm/problem.h"

#include <cmath>

namespace wetfront::mpm {

namespace {

/// Abscissae on [-1, 1] and weights of the n-point Gauss-Legendre rule, by Newton's method on P_n.
void gauss_legendre(int n, std::vector<double>& place, std::vector<double>& weight) {
  const double pi = std::acos(-1.0);
  for (int k = 0; k < n; ++k) {
    double x = -std::cos(pi * (k + 0.75) / (n + 0.5));
    double slope = 0;
    for (int iteration = 0; iteration < 50; ++iteration) {
      double before = 1, value = x;
      for (int degree = 2; degree <= n; ++degree) {
        const double next = ((2 * degree - 1) * x * value - (degree - 1) * before) / degree;
        before = value;
        value = next;
      }
      slope = n * (x * value - before) / (x * x - 1);
      const double change = value / slope;
      x -= change;
      if (std::abs(change) < 1e-16) break;
    }
    place.push_back(x);
    weight.push_back(2 / ((1 - x * x) * slope * slope));
  }
}

int points_per_axis(int points_per_cell, int dim) {
  constexpr int most = 5;
  for (int n = 1; n <= most; ++n) {
    int product = 1;
    for (int a = 0; a < dim; ++a) product *= n;
    if (product == points_per_cell) return n;
  }
  throw CannotPlan("cannot seed " + std::to_string(points_per_cell) +
                   " points per cell (points sit at Gauss places, n^" + std::to_string(dim) +
                   " per cell with n from 1 to 5). Use 4 in two dimensions, 8 in three");
}

}  // namespace

template <int dim>
MaterialPoints<dim> seed(const Grid<dim>& grid, int points_per_cell) {
  const int n = points_per_axis(points_per_cell, dim);
  std::vector<double> place, weight, volumes;
  gauss_legendre(n, place, weight);
  int regions = 0;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) regions = std::max(regions, grid.region(cell) + 1);
  std::vector<Vector<dim>> positions;
  Stencil<dim> s;
  for (int region = 0; region < regions; ++region)
    for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
      if (grid.region(cell) != region) continue;
      for (int k = 0; k < points_per_cell; ++k) {
        Vector<dim> xi{};
        double w = 1;
        for (int a = 0, rest = k; a < dim; ++a, rest /= n) {
          xi[a] = place[static_cast<std::size_t>(rest % n)];
          w *= weight[static_cast<std::size_t>(rest % n)];
        }
        positions.push_back(grid.place(cell, xi));
        volumes.push_back(w * grid.stencil(cell, xi, s));
      }
    }
  const std::vector<std::size_t> counts(grid.cell_count(), static_cast<std::size_t>(points_per_cell));
  return MaterialPoints<dim>(grid, positions, volumes, counts);
}

template MaterialPoints<2> seed(const Grid<2>&, int);
template MaterialPoints<3> seed(const Grid<3>&, int);

}  // namespace wetfront::mpm
