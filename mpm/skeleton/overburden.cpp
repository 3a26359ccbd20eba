#include "mpm/skeleton/overburden.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/boundary/time_record.h"
#include "mpm/laws/soil_water.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::mpm {

template <int dim>
Overburden<dim>::Overburden(const StagePlan<dim>& plan)
    : plan_(plan), faces_(plan.fields.grid, plan.problem.mesh), up_(upward(plan.problem)) {
  for (double g : plan.problem.gravity) gravity_ += g * g;
  gravity_ = std::sqrt(gravity_);
  if (plan.stage.liquid && plan.problem.water)
    for (const Soil& soil : plan.problem.soils)
      water_of_soil_.emplace_back(
          [laws = tabulated_soil_water(soil, *plan.problem.water), kind = soil.bishop](double p) {
            const double s = laws.saturation(p);
            return Water{p, s, kind == Bishop::saturation ? s : laws.curve.effective(-p)};
          });
  sort_cells();
}

/// Cells by where they lie across gravity, so that a line meets few.
template <int dim>
void Overburden<dim>::sort_cells() {
  const Grid<dim>& grid = plan_.fields.grid;
  // The axes of the mesh least along gravity, made perpendicular to it.
  int tallest = 0;
  for (int a = 1; a < dim; ++a)
    if (std::abs(up_[a]) > std::abs(up_[tallest])) tallest = a;
  for (int a = 0, k = 0; a < dim; ++a) {
    if (a == tallest) continue;
    Vector<dim>& axis = across_[static_cast<std::size_t>(k++)];
    for (int b = 0; b < dim; ++b) axis[b] = (a == b ? 1.0 : 0.0) - up_[a] * up_[b];
  }
  std::array<double, 2> high{};
  low_.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < grid.node_count(); ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      low_[k] = std::min(low_[k], dot<dim>(across_[k], grid.node(static_cast<int>(i))));
      high[k] = std::max(high[k], dot<dim>(across_[k], grid.node(static_cast<int>(i))));
    }
  const double rough = std::pow(static_cast<double>(grid.cell_count()), 1.0 / dim);
  for (std::size_t k = 0; k < 2; ++k) {
    buckets_[k] = high[k] > low_[k] ? 1 + static_cast<long>(rough) : 1;
    width_[k] = high[k] > low_[k] ? (high[k] - low_[k]) / static_cast<double>(buckets_[k]) : 1;
  }
  cells_of_bucket_.resize(static_cast<std::size_t>(buckets_[0] * buckets_[1]));
  cell_faces_.resize(grid.cell_count());
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    if (!plan_.fields.points.occupied(cell)) continue;
    std::array<long, 2> first{buckets_[0], buckets_[1]}, last{0, 0};
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      const auto at = bucket_of(grid.node(grid.cell_nodes_of(cell)[i]));
      for (std::size_t k = 0; k < 2; ++k) {
        first[k] = std::min(first[k], at[k]);
        last[k] = std::max(last[k], at[k]);
      }
    }
    for (long j = first[1]; j <= last[1]; ++j)
      for (long i = first[0]; i <= last[0]; ++i)
        cells_of_bucket_[static_cast<std::size_t>(j * buckets_[0] + i)].push_back(cell);
    for (int f = 0; f < cell_faces<dim>; ++f) {
      Face& face = cell_faces_[cell][static_cast<std::size_t>(f)];
      const auto local = local_face<dim>(f);
      const auto integrals = Faces<dim>::integrals(grid, cell, f);
      for (std::size_t i = 0; i < local.size(); ++i)
        for (int a = 0; a < dim; ++a) {
          face.normal[a] += integrals[i][a];
          face.centre[a] += grid.node(grid.cell_nodes_of(cell)[local[i]])[a] / static_cast<double>(local.size());
        }
      const double size = length<dim>(face.normal);
      for (double& component : face.normal) component /= size;
    }
  }
}

template <int dim>
std::array<long, 2> Overburden<dim>::bucket_of(const Vector<dim>& x) const {
  std::array<long, 2> at{};
  for (std::size_t k = 0; k < 2; ++k)
    at[k] = std::clamp(static_cast<long>((dot<dim>(across_[k], x) - low_[k]) / width_[k]), 0L, buckets_[k] - 1);
  return at;
}

/// The part of the line x + s up, s >= 0, inside a cell.
template <int dim>
typename Overburden<dim>::Range Overburden<dim>::crossing(std::size_t cell, const Vector<dim>& x) const {
  Range range{0, std::numeric_limits<double>::infinity(), -1};
  for (int f = 0; f < cell_faces<dim>; ++f) {
    const Face& face = cell_faces_[cell][static_cast<std::size_t>(f)];
    const double along = dot<dim>(face.normal, up_);
    const double ahead = dot<dim>(face.normal, face.centre) - dot<dim>(face.normal, x);  // distance to the face's plane
    if (std::abs(along) < 1e-12) {
      if (ahead < 0) return {};
    } else if (along > 0) {
      if (ahead / along < range.until) range = {range.from, ahead / along, f};
    } else {
      range.from = std::max(range.from, ahead / along);
    }
  }
  return range;
}

template <int dim>
void Overburden<dim>::below_surface(const Vector<dim>& x, const Range& range,
                                    const std::function<void(double, double)>& body) const {
  const auto& line = plan_.problem.surface;
  if (line.empty() || dim != 2) return body(range.from, range.until);
  // Height of the surface above the place at s: linear between the line's corners.
  const auto above = [&](double s) {
    const double px = x[0] + s * up_[0], py = x[1] + s * up_[1];
    std::size_t k = 1;
    while (k + 1 < line.size() && line[k][0] < px) ++k;
    const auto &a = line[k - 1], &b = line[k];
    const double share = b[0] > a[0] ? std::clamp((px - a[0]) / (b[0] - a[0]), 0.0, 1.0) : 0.0;
    return a[1] + share * (b[1] - a[1]) - py;
  };
  std::vector<double> corners{range.from, range.until};
  if (up_[0] != 0)
    for (const auto& corner : line)
      if (const double s = (corner[0] - x[0]) / up_[0]; s > range.from && s < range.until) corners.push_back(s);
  std::sort(corners.begin(), corners.end());
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const double a = above(corners[k - 1]), b = above(corners[k]);
    if (a <= 0 && b <= 0) continue;
    const double pass = corners[k - 1] + (corners[k] - corners[k - 1]) * (a / (a - b));
    body(a < 0 ? pass : corners[k - 1], b < 0 ? pass : corners[k]);
  }
}

template <int dim>
typename Overburden<dim>::Water Overburden<dim>::water_at(std::size_t cell, const Vector<dim>& x) const {
  const Grid<dim>& grid = plan_.fields.grid;
  Stencil<dim> s;
  grid.stencil(cell, grid.local(cell, x), s);
  double p = 0;
  for (int i = 0; i < cell_nodes<dim>; ++i)
    p += s.value[i] * plan_.problem.initial_pressure[static_cast<std::size_t>(grid.cell_nodes_of(cell)[i])];
  return water_of_soil_[static_cast<std::size_t>(grid.region(cell))](p);
}

/// Soil and its water between two places of the line, by two Gauss points (saturation varies between them).
template <int dim>
double Overburden<dim>::weight(std::size_t cell, const Vector<dim>& x, double from, double until) const {
  const Soil& soil = plan_.problem.soils[static_cast<std::size_t>(plan_.fields.grid.region(cell))];
  double density = (1 - soil.porosity) * soil.grain_density;
  if (!water_of_soil_.empty())
    for (double side : {-1.0, 1.0}) {
      const double s = 0.5 * (from + until) + side * 0.5 / std::sqrt(3.0) * (until - from);
      Vector<dim> place = x;
      for (int a = 0; a < dim; ++a) place[a] += s * up_[a];
      density += 0.5 * soil.porosity * plan_.problem.water->density * water_at(cell, place).saturation;
    }
  return density * gravity_ * (until - from);
}

/// Loads where the line leaves the soil.
template <int dim>
double Overburden<dim>::load_on_top(std::size_t cell, int face) const {
  double load = 0;
  const int side = face >= 0 ? faces_.side(cell, face) : -1;
  for (const SkeletonBoundary& boundary : plan_.problem.skeleton_boundary) {
    const auto* traction = std::get_if<Traction>(&boundary);
    if (traction == nullptr) continue;
    const double factor = traction->factor.time.empty() ? 1.0 : value_until(traction->factor, plan_.begin_time());
    const bool here = side >= 0 ? plan_.problem.mesh.sides[static_cast<std::size_t>(side)].name == traction->side
                                : traction->side == free_surface;
    if (!here) continue;
    double pushed = traction->pressure;
    if (side >= 0) {  // per horizontal area
      const Vector<dim>& normal = cell_faces_[cell][static_cast<std::size_t>(face)].normal;
      double down = 0;
      for (int a = 0; a < dim; ++a) down -= traction->force[static_cast<std::size_t>(a)] * up_[a];
      pushed += down / dot<dim>(normal, up_);
    }
    load += factor * pushed;
  }
  return load;
}

template <int dim>
double Overburden<dim>::above(const Vector<dim>& x) const {
  const auto bucket = bucket_of(x);
  double sum = 0, top = -1;
  std::size_t top_cell = 0;
  int top_face = -1;
  for (std::size_t cell : cells_of_bucket_[static_cast<std::size_t>(bucket[1] * buckets_[0] + bucket[0])]) {
    const Range range = crossing(cell, x);
    if (!(range.until > range.from)) continue;
    below_surface(x, range, [&](double from, double until) {
      sum += weight(cell, x, from, until);
      if (until <= top) return;
      top = until;
      top_cell = cell;
      top_face = until < range.until ? -1 : range.last_face;
    });
  }
  if (top < 0) return 0;
  return sum + load_on_top(top_cell, top_face);
}

template <int dim>
double Overburden<dim>::pore_stress(std::size_t cell, const Vector<dim>& x) const {
  if (water_of_soil_.empty()) return 0;
  const Water water = water_at(cell, x);
  return water.bishop * water.pressure;
}

template class Overburden<2>;
template class Overburden<3>;

}  // namespace wetfront::mpm
