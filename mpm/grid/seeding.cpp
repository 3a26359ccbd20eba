#include "mpm/grid/seeding.h"

#include "mpm/grid/polygon.h"
#include "mpm/problem.h"

#include <cmath>
#include <limits>

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

template <int dim>
struct Points {
  std::vector<Vector<dim>> positions;
  std::vector<double> volumes;
  std::vector<std::size_t> count_of_cell;
};

struct Rule {
  int n = 1;
  std::vector<double> place, weight;
};

template <int dim>
void fill_cell(const Grid<dim>& grid, std::size_t cell, const Rule& rule, Points<dim>& points) {
  Stencil<dim> s;
  for (int k = 0; k < static_cast<int>(points.count_of_cell[cell]); ++k) {
    Vector<dim> xi{};
    double w = 1;
    for (int a = 0, rest = k; a < dim; ++a, rest /= rule.n) {
      xi[a] = rule.place[static_cast<std::size_t>(rest % rule.n)];
      w *= rule.weight[static_cast<std::size_t>(rest % rule.n)];
    }
    points.positions.push_back(grid.place(cell, xi));
    points.volumes.push_back(w * grid.stencil(cell, xi, s));
  }
}

/// Points in a quadrilateral; in a triangle when the last two corners are one.
void fill_quadrilateral(const std::array<Vector<2>, 4>& corner, const Rule& rule, Points<2>& points) {
  if (rule.n == 1) {  // the centroid: the middle of the map is not, in a triangle
    Polygon polygon;
    for (const auto& x : corner) polygon.add(x);
    const AreaAndCentroid whole = measure(polygon);
    points.positions.push_back(whole.centroid);
    points.volumes.push_back(whole.area);
    return;
  }
  Stencil<2> s;
  for (std::size_t j = 0; j < static_cast<std::size_t>(rule.n); ++j)
    for (std::size_t i = 0; i < static_cast<std::size_t>(rule.n); ++i) {
      reference_stencil<2>({rule.place[i], rule.place[j]}, s);
      Vector<2> x{}, du{}, dv{};
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t a = 0; a < 2; ++a) {
          x[a] += s.value[k] * corner[k][a];
          du[a] += s.gradient[k][0] * corner[k][a];
          dv[a] += s.gradient[k][1] * corner[k][a];
        }
      points.positions.push_back(x);
      points.volumes.push_back(rule.weight[i] * rule.weight[j] * (du[0] * dv[1] - du[1] * dv[0]));
    }
}

/// Up to four corners at a time, fanned out from the first.
void fill_polygon(const Polygon& polygon, const Rule& rule, Points<2>& points) {
  for (int i = 1; i + 1 < polygon.size; i += 2) {
    const Vector<2>& last = polygon[std::min(i + 2, polygon.size - 1)];
    fill_quadrilateral({polygon[0], polygon[i], polygon[i + 1], last}, rule, points);
  }
}

void check_surface(const std::vector<meshes::Point>& surface) {
  for (std::size_t k = 0; k + 1 < surface.size(); ++k)
    if (surface[k + 1][0] < surface[k][0])
      throw CannotPlan("the surface of the soil goes back at its corner " + std::to_string(k + 2) +
                       " (x = " + std::to_string(surface[k + 1][0]) + " m). Give its corners from left to right");
}

/// The convex pieces of a cell that lie below the surface: one per stretch of the line and beyond each end.
std::vector<Polygon> pieces_below(const Polygon& cell, const std::vector<meshes::Point>& surface) {
  const double far = std::numeric_limits<double>::infinity();
  std::vector<Polygon> pieces;
  for (std::size_t k = 0; k <= surface.size(); ++k) {
    const bool first = k == 0, last = k == surface.size();
    const meshes::Point &b = last ? surface.back() : surface[k], &a = first ? surface.front() : surface[k - 1];
    const double from = first ? -far : a[0], until = last ? far : b[0];
    if (!(until > from)) continue;
    Polygon piece = cell;
    if (!first) piece = clipped(piece, {{-1, 0}, -from});
    if (!last) piece = clipped(piece, {{1, 0}, until});
    Vector<2> normal{0, 1};
    if (!first && !last) {
      const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
      normal = {-(b[1] - a[1]) / length, (b[0] - a[0]) / length};
    }
    const meshes::Point& on = first ? b : a;
    piece = clipped(piece, {normal, normal[0] * on[0] + normal[1] * on[1]});
    if (piece.size >= 3) pieces.push_back(piece);
  }
  return pieces;
}

/// Fills what the surface leaves of a cell; false when that is all of it and nothing was done.
bool fill_cut_cell(const Grid<2>& grid, std::size_t cell, const std::vector<meshes::Point>& surface, const Rule& rule,
                   Points<2>& points) {
  // Far below any fraction that could matter to a result and far above the round-off of clipping.
  constexpr double negligible = 1e-9;
  Polygon whole;
  for (int i = 0; i < 4; ++i) whole.add(grid.node(grid.cell_nodes_of(cell)[i]));
  const double all = measure(whole).area;
  double below = 0;
  const auto pieces = pieces_below(whole, surface);
  for (const Polygon& piece : pieces) below += measure(piece).area;
  if (below >= (1 - negligible) * all) return false;
  const std::size_t before = points.positions.size();
  if (below > negligible * all)
    for (const Polygon& piece : pieces)
      if (measure(piece).area > 1e-12 * all) fill_polygon(piece, rule, points);
  points.count_of_cell[cell] = points.positions.size() - before;
  return true;
}

}  // namespace

template <int dim>
MaterialPoints<dim> seed(const Grid<dim>& grid, int points_per_cell, const std::vector<meshes::Point>& surface,
                         const std::vector<char>& empty_cells) {
  Rule rule{points_per_axis(points_per_cell, dim), {}, {}};
  gauss_legendre(rule.n, rule.place, rule.weight);
  if (dim != 2 && !surface.empty())
    throw CannotPlan(
        "the scene has a surface inside cells in three dimensions (a line says where it is in two only). "
        "Let the mesh follow the surface");
  check_surface(surface);
  if (!empty_cells.empty() && empty_cells.size() != grid.cell_count())
    throw CannotPlan("the problem says for " + std::to_string(empty_cells.size()) +
                     " cells whether they are empty, but has " + std::to_string(grid.cell_count()) +
                     " (one entry belongs to each cell). Give all, or none");
  int regions = 0;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) regions = std::max(regions, grid.region(cell) + 1);
  Points<dim> points;
  points.count_of_cell.assign(grid.cell_count(), static_cast<std::size_t>(points_per_cell));
  for (int region = 0; region < regions; ++region)
    for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
      if (grid.region(cell) != region) continue;
      if (!empty_cells.empty() && empty_cells[cell] != 0) {
        points.count_of_cell[cell] = 0;
        continue;
      }
      if constexpr (dim == 2)
        if (!surface.empty() && fill_cut_cell(grid, cell, surface, rule, points)) continue;
      fill_cell(grid, cell, rule, points);
    }
  if (points.positions.empty())
    throw CannotPlan(
        "what lies above the surface or is marked empty leaves no soil (it is every cell of the mesh). Raise the "
        "surface, "
        "or check its units [m]");
  return MaterialPoints<dim>(grid, points.positions, points.volumes, points.count_of_cell);
}

template MaterialPoints<2> seed(const Grid<2>&, int, const std::vector<meshes::Point>&, const std::vector<char>&);
template MaterialPoints<3> seed(const Grid<3>&, int, const std::vector<meshes::Point>&, const std::vector<char>&);

}  // namespace wetfront::mpm
