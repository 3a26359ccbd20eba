#include "mpm/grid/grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::mpm {

namespace {

/// Inverse of a dim x dim matrix m[row][column]; returns the determinant.
template <int dim>
double invert(const std::array<Vector<dim>, dim>& m, std::array<Vector<dim>, dim>& inverse) {
  if constexpr (dim == 2) {
    const double det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    inverse = {{{m[1][1] / det, -m[0][1] / det}, {-m[1][0] / det, m[0][0] / det}}};
    return det;
  } else {
    const auto minor = [&m](int r0, int r1, int c0, int c1) { return m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0]; };
    const double det = m[0][0] * minor(1, 2, 1, 2) - m[0][1] * minor(1, 2, 0, 2) + m[0][2] * minor(1, 2, 0, 1);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) inverse[c][r] = minor((r + 1) % 3, (r + 2) % 3, (c + 1) % 3, (c + 2) % 3) / det;
    return det;
  }
}

template <int dim>
bool inside(const Vector<dim>& xi) {
  // A point on the border between two cells belongs to whichever holds it already.
  constexpr double border = 1 + 1e-10;
  return std::all_of(xi.begin(), xi.end(), [](double c) { return std::abs(c) <= border; });
}

}  // namespace

template <int dim>
Grid<dim>::Grid(const meshes::Mesh& mesh) : columns(mesh.nodes.size()), nodes_(mesh.cells), regions_(mesh.region) {
  for (const auto& point : mesh.nodes) {
    Vector<dim> x{};
    std::copy_n(point.begin(), dim, x.begin());
    positions_.push_back(x);
  }
  for (std::size_t cell = 0; cell < regions_.size(); ++cell) {
    maps_.push_back(map_at(cell, {}));
    // The map is affine when the corners lie where the derivative at the centre predicts them.
    double worst = 0;
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      const Vector<dim>& x = node(cell_nodes_of(cell)[i]);
      for (int a = 0; a < dim; ++a) {
        double bend = -node_sign(i, a);
        for (int b = 0; b < dim; ++b) bend += maps_[cell].inverse[a][b] * (x[b] - maps_[cell].centre[b]);
        worst = std::max(worst, std::abs(bend));
      }
    }
    affine_.push_back(worst < 1e-9 ? 1 : 0);
    altitude_.push_back(measure_altitude(cell));
  }
  find_neighbours();
}

template <int dim>
typename Grid<dim>::AffineMap Grid<dim>::map_at(std::size_t cell, const Vector<dim>& xi) const {
  Stencil<dim> s;
  reference_stencil<dim>(xi, s);
  AffineMap map;
  std::array<Vector<dim>, dim> jacobian{};
  for (int i = 0; i < cell_nodes<dim>; ++i) {
    const Vector<dim>& x = node(cell_nodes_of(cell)[i]);
    for (int a = 0; a < dim; ++a) {
      map.centre[a] += s.value[i] * x[a];
      for (int b = 0; b < dim; ++b) jacobian[a][b] += x[a] * s.gradient[i][b];
    }
  }
  map.determinant = invert<dim>(jacobian, map.inverse);
  return map;
}

template <int dim>
Vector<dim> Grid<dim>::place(std::size_t cell, const Vector<dim>& xi) const {
  Stencil<dim> s;
  reference_stencil<dim>(xi, s);
  Vector<dim> x{};
  for (int i = 0; i < cell_nodes<dim>; ++i)
    for (int a = 0; a < dim; ++a) x[a] += s.value[i] * node(cell_nodes_of(cell)[i])[a];
  return x;
}

template <int dim>
Vector<dim> Grid<dim>::local(std::size_t cell, const Vector<dim>& x) const {
  Vector<dim> xi = maps_[cell].local(x);
  if (affine(cell)) return xi;
  // Newton's method on a bilinear map converges quadratically from the affine guess; 20 is never reached by a convex
  // cell, and a place far outside is reported as outside by the caller.
  for (int iteration = 0; iteration < 20; ++iteration) {
    for (double& c : xi) c = std::clamp(c, -3.0, 3.0);
    const Vector<dim> step = map_at(cell, xi).local(x);
    double change = 0;
    for (int a = 0; a < dim; ++a) {
      change = std::max(change, std::abs(step[a]));
      xi[a] += step[a];
    }
    if (change < 1e-14) break;
  }
  return xi;
}

template <int dim>
double Grid<dim>::stencil(std::size_t cell, const Vector<dim>& xi, Stencil<dim>& out) const {
  reference_stencil<dim>(xi, out);
  const AffineMap other = affine(cell) ? AffineMap{} : map_at(cell, xi);
  const AffineMap& map = affine(cell) ? maps_[cell] : other;
  for (int i = 0; i < cell_nodes<dim>; ++i) {
    const Vector<dim> reference = out.gradient[i];
    for (int a = 0; a < dim; ++a) {
      out.gradient[i][a] = 0;
      for (int b = 0; b < dim; ++b) out.gradient[i][a] += map.inverse[b][a] * reference[b];
    }
  }
  return map.determinant;
}

template <int dim>
Vector<dim> Grid<dim>::face_normal(std::size_t cell, const Vector<dim>& xi, int axis, bool upper) const {
  Vector<dim> normal = map_at(cell, xi).inverse[static_cast<std::size_t>(axis)];
  const double size = (upper ? 1 : -1) * length<dim>(normal);
  for (double& n : normal) n /= size;
  return normal;
}

template <int dim>
double Grid<dim>::measure_altitude(std::size_t cell) const {
  // |dxi_a/dx| is 2 / (distance of the two faces across axis a) in an affine cell; the corners bound it in others.
  double altitude = std::numeric_limits<double>::infinity();
  for (int i = 0; i < cell_nodes<dim>; ++i) {
    Vector<dim> corner{};
    for (int a = 0; a < dim; ++a) corner[a] = node_sign(i, a);
    const AffineMap map = map_at(cell, corner);
    for (int a = 0; a < dim; ++a) {
      double square = 0;
      for (int b = 0; b < dim; ++b) square += map.inverse[a][b] * map.inverse[a][b];
      altitude = std::min(altitude, 2 / std::sqrt(square));
    }
  }
  return altitude;
}

template <int dim>
void Grid<dim>::find_neighbours() {
  std::vector<std::vector<int>> cells_at(node_count());
  for (std::size_t cell = 0; cell < cell_count(); ++cell)
    for (int i = 0; i < cell_nodes<dim>; ++i)
      cells_at[static_cast<std::size_t>(cell_nodes_of(cell)[i])].push_back(static_cast<int>(cell));
  neighbour_start_.assign(1, 0);
  std::vector<int> found;
  for (std::size_t cell = 0; cell < cell_count(); ++cell) {
    found.clear();
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int other : cells_at[static_cast<std::size_t>(cell_nodes_of(cell)[i])]) found.push_back(other);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    neighbours_.insert(neighbours_.end(), found.begin(), found.end());
    neighbour_start_.push_back(static_cast<int>(neighbours_.size()));
  }
}

template <int dim>
int Grid<dim>::find_cell(const Vector<dim>& x, int start) const {
  if (start >= 0) {
    if (inside<dim>(local(static_cast<std::size_t>(start), x))) return start;
    const auto cell = static_cast<std::size_t>(start);
    for (int k = neighbour_start_[cell]; k < neighbour_start_[cell + 1]; ++k)
      if (inside<dim>(local(static_cast<std::size_t>(neighbours_[static_cast<std::size_t>(k)]), x)))
        return neighbours_[static_cast<std::size_t>(k)];
  }
  // Rare: a start, or a point that crossed more than one cell in a step.
  for (std::size_t cell = 0; cell < cell_count(); ++cell)
    if (inside<dim>(local(cell, x))) return static_cast<int>(cell);
  return -1;
}

template class Grid<2>;
template class Grid<3>;

}  // namespace wetfront::mpm
