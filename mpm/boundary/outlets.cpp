#include "mpm/boundary/outlets.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/grid/soils_of_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace wetfront::mpm {

namespace {

template <int dim>
double film_of(const StagePlan<dim>& plan, std::size_t cell, int region, double altitude) {
  const Problem<dim>& problem = plan.problem;
  const Soil& soil = problem.soils[static_cast<std::size_t>(region)];
  const double factor = problem.conductivity_factor.empty() ? 1 : problem.conductivity_factor[cell];
  const double widest = std::max({soil.anisotropy[0], soil.anisotropy[1], dim == 3 ? soil.anisotropy[2] : 0.0});
  return film_conductance * factor * widest * soil.intrinsic_permeability / (problem.water->viscosity * altitude);
}

/// Local nodes and weights of a piece as the scheme of the scene wants them.
template <int dim>
void place_weights(const StagePlan<dim>& plan, const SurfacePiece<dim>& piece, Outlet<dim>& outlet) {
  const auto& grid = plan.fields.grid;
  outlet.count = cell_nodes<dim>;
  outlet.weight = piece.weight;
  outlet.centre = piece.centre;
  std::copy_n(grid.cell_nodes_of(piece.cell), cell_nodes<dim>, outlet.node.begin());
  if (plan.problem.rain_scheme == RainScheme::martinelli_2020) {
    double sum = 0;
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      Vector<dim> away{};
      for (int a = 0; a < dim; ++a) away[a] = grid.node(outlet.node[i])[a] - piece.centre[a];
      if (dot<dim>(away, piece.area) <= 0) outlet.weight[i] = 0;
      sum += outlet.weight[i];
    }
    for (double& weight : outlet.weight) weight /= sum;
  }
}

/// Bandara & Soga 2016: the points of the cell nearest to the surface, those within half of the least and the mean
/// distance, share the flux by volume.
template <int dim>
void place_at_points(const StagePlan<dim>& plan, const SurfacePiece<dim>& piece, Outlet<dim>& outlet) {
  const auto& grid = plan.fields.grid;
  const auto& points = plan.fields.points;
  const Column& volume = *points.columns.find("volume");
  std::vector<std::size_t> slots;
  for (const Block& block : points.blocks())
    if (block.cell == piece.cell)
      for (std::size_t p = block.first; p < block.first + block.count; ++p) slots.push_back(p);
  const double size = std::sqrt(dot<dim>(piece.area, piece.area));
  const auto depth = [&](std::size_t p) {
    Vector<dim> below = piece.centre;
    for (int a = 0; a < dim; ++a) below[a] -= points.position(p)[a];
    return dot<dim>(below, piece.area) / size;
  };
  double least = std::numeric_limits<double>::infinity(), mean = 0;
  for (const std::size_t p : slots) {
    least = std::min(least, depth(p));
    mean += depth(p) / static_cast<double>(slots.size());
  }
  outlet.count = cell_nodes<dim>;
  outlet.centre = {};
  std::copy_n(grid.cell_nodes_of(piece.cell), cell_nodes<dim>, outlet.node.begin());
  double sum = 0;
  Stencil<dim> s;
  for (const std::size_t p : slots) {
    if (depth(p) > 0.5 * (least + mean)) continue;
    reference_stencil<dim>(grid.local(piece.cell, points.position(p)), s);
    for (int i = 0; i < cell_nodes<dim>; ++i) outlet.weight[i] += volume[0][p] * s.value[i];
    for (int a = 0; a < dim; ++a) outlet.centre[a] += volume[0][p] * points.position(p)[a];
    sum += volume[0][p];
  }
  for (double& weight : outlet.weight) weight /= sum;
  for (double& x : outlet.centre) x /= sum;
}

/// The vertical line through x meets soil above it: an occupied cell whose stretch of the line lies higher.
bool shadowed(const StagePlan<2>& plan, const Surface<2>& surface, const Vector<2>& x) {
  const auto& grid = plan.fields.grid;
  const Vector<2> up = upward(plan.problem), across{up[1], -up[0]};
  const double here = dot<2>(x, across), height = dot<2>(x, up);
  for (const Block& block : plan.fields.points.blocks()) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (int i = 0; i < 4; ++i) {
      const Vector<2>&a = grid.node(block.nodes[i]), &b = grid.node(block.nodes[(i + 1) % 4]);
      const double from = dot<2>(a, across) - here, until = dot<2>(b, across) - here;
      if ((from < 0) == (until < 0)) continue;
      const double at = dot<2>(a, up) + from / (from - until) * (dot<2>(b, up) - dot<2>(a, up));
      low = std::min(low, at);
      high = std::max(high, at);
    }
    // Cells that begin at the surface or above it: a thousandth of a cell is far more than the surface's error.
    const double slack = 1e-3 * grid.smallest_altitude(block.cell);
    if (high > height + slack && low >= height - slack && !surface.cut(block.cell)) return true;
  }
  return false;
}

/// Collects pieces: those on cell faces at their nodes, others one by one.
template <int dim>
class Collector {
 public:
  Collector(const StagePlan<dim>& plan, const Surface<dim>& surface)
      : plan_(plan), surface_(surface), up_(upward(plan.problem)) {
    altitude_.assign(plan.fields.grid.node_count(), 0.0);
    for (const Block& block : plan.fields.points.blocks())
      for (int i = 0; i < cell_nodes<dim>; ++i) {
        double& h = altitude_[static_cast<std::size_t>(block.nodes[i])];
        h = std::max(h, plan.fields.grid.smallest_altitude(block.cell));
      }
  }

  void add(const SurfacePiece<dim>& piece, int index) {
    in_shade_ = dot<dim>(piece.area, up_) > 0 && in_shade(piece);
    if (plan_.problem.rain_scheme == RainScheme::bandara_2016) {
      Outlet<dim> outlet = fresh(piece, altitude_of(piece.cell));
      outlet.piece = index;
      place_at_points(plan_, piece, outlet);
      share(piece, 1, outlet);
      single_.push_back(outlet);
    } else if (piece.face < 0) {
      Outlet<dim> outlet = fresh(piece, altitude_of(piece.cell));
      outlet.piece = index;
      place_weights(plan_, piece, outlet);
      share(piece, 1, outlet);
      single_.push_back(outlet);
    } else {
      for (int i = 0; i < cell_nodes<dim>; ++i)
        if (piece.weight[i] > 0) add_to_node(piece, plan_.fields.grid.cell_nodes_of(piece.cell)[i], piece.weight[i]);
    }
  }

  std::vector<Outlet<dim>> result() const {
    std::vector<Outlet<dim>> all;
    for (const auto& entry : at_node_) all.push_back(entry.second);
    all.insert(all.end(), single_.begin(), single_.end());
    return all;
  }

 private:
  double altitude_of(std::size_t cell) const { return plan_.fields.grid.smallest_altitude(cell); }

  Outlet<dim> fresh(const SurfacePiece<dim>& piece, double altitude) const {
    Outlet<dim> outlet;
    outlet.cell = piece.cell;
    outlet.region = soil_at<dim>(plan_.fields.points, piece.cell, piece.centre);
    outlet.film = film_of(plan_, piece.cell, outlet.region, altitude);
    return outlet;
  }

  void add_to_node(const SurfacePiece<dim>& piece, int node, double weight) {
    const double altitude = altitude_[static_cast<std::size_t>(node)];
    const Outlet<dim> by_itself = fresh(piece, altitude);
    auto [entry, is_new] = at_node_.try_emplace(node, by_itself);
    Outlet<dim>& outlet = entry->second;
    outlet.count = 1;
    outlet.node[0] = node;
    outlet.weight[0] = 1;
    outlet.centre = plan_.fields.grid.node(node);
    outlet.region = std::min(outlet.region, by_itself.region);
    outlet.film = std::max(outlet.film, by_itself.film);
    share(piece, weight, outlet);
  }

  void share(const SurfacePiece<dim>& piece, double part, Outlet<dim>& outlet) const {
    for (int a = 0; a < dim; ++a) outlet.area[a] += part * piece.area[a];
    const double horizontal = part * dot<dim>(piece.area, up_);
    outlet.size += part * std::sqrt(dot<dim>(piece.area, piece.area));
    outlet.hidden += std::max(-horizontal, 0.0);
    if (horizontal > 0) (in_shade_ ? outlet.shaded : outlet.open) += horizontal;
  }

  bool in_shade(const SurfacePiece<dim>& piece) const {
    if constexpr (dim == 2)
      return shadowed(plan_, surface_, piece.centre);
    else
      return false;
  }

  const StagePlan<dim>& plan_;
  const Surface<dim>& surface_;
  Vector<dim> up_;
  bool in_shade_ = false;         ///< the piece that is being added
  std::vector<double> altitude_;  ///< largest of the occupied cells around a node [m]
  std::map<int, Outlet<dim>> at_node_;
  std::vector<Outlet<dim>> single_;
};

template <int dim>
bool belongs(const StagePlan<dim>& plan, const SurfacePiece<dim>& piece, const std::string& side) {
  if (side == free_surface) return !piece.border;
  return piece.border && piece.side >= 0 && plan.problem.mesh.sides[static_cast<std::size_t>(piece.side)].name == side;
}

}  // namespace

template <int dim>
std::vector<Outlet<dim>> outlets(const StagePlan<dim>& plan, const Surface<dim>& surface, const std::string& side,
                                 const std::string& who, const Origin& origin) {
  const bool free = side == free_surface;
  if (!free) named_side(plan.problem.mesh, side, who, origin);
  Collector<dim> collector(plan, surface);
  for (std::size_t k = 0; k < surface.pieces().size(); ++k)
    if (belongs(plan, surface.pieces()[k], side)) collector.add(surface.pieces()[k], static_cast<int>(k));
  auto result = collector.result();
  if (!result.empty()) return result;
  if (free)
    throw CannotPlan(origin + ": " + who +
                     " is asked for on the free surface, but the soil has none: it fills the mesh to "
                     "its border. Name the side of the mesh");
  throw CannotPlan(origin + ": " + who + " is asked for on side '" + side +
                   "', but no cell behind that side holds a material point, so it can never act. Name a side that "
                   "borders soil, or mpm::free_surface");
}

template <int dim>
void check_rain(const StagePlan<dim>& plan, const Surface<dim>& surface, const std::vector<Outlet<dim>>& outlets,
                const std::string& side, bool has_moved, const Origin& origin) {
  const bool free = side == free_surface;
  const std::string what = origin + ": rainfall is asked for on " + (free ? "the free surface" : "side '" + side + "'");
  double size = 0, open = 0, hidden = 0;
  for (const auto& outlet : outlets) {
    // A thousandth of a piece: rain has no place there, whatever round-off says of the rest.
    if (!has_moved && outlet.shaded > 1e-3 * outlet.size)
      throw CannotPlan(what + ", but soil lies above it (at x = " + std::to_string(outlet.centre[0]) +
                       " m), so rain cannot fall there. Name only what lies under the open sky");
    size += outlet.size;
    open += outlet.open;
    hidden += outlet.hidden;
  }
  // A millionth of the side's area: far above round-off, far below any slope that rain could be meant for.
  if (open < 1e-6 * size || (!free && hidden > 1e-6 * size))
    throw CannotPlan(what +
                     ", which is vertical or faces downwards (rain falls per horizontal area, so none would reach "
                     "the soil). Name a side that faces the sky");
  std::set<std::string> named;
  for (const auto& boundary : plan.problem.water_boundary)
    std::visit([&named](const auto& b) { named.insert(b.side); }, boundary);
  const Vector<dim> up = upward(plan.problem);
  for (const auto& piece : surface.pieces()) {
    const double area = std::sqrt(dot<dim>(piece.area, piece.area));
    if (dot<dim>(piece.area, up) < 1e-6 * area) continue;
    if (free && piece.border && (piece.side < 0 || !named.contains(plan.problem.mesh.sides[piece.side].name)))
      throw CannotPlan(what + ", but soil also touches the border of the mesh from below (" +
                       (piece.side < 0 ? std::string("on no named side")
                                       : "side '" + plan.problem.mesh.sides[piece.side].name + "'") +
                       "), where no condition lets rain in. Name that side too, or give the mesh empty cells above");
    if (!free && !piece.border && !named.contains(free_surface))
      throw CannotPlan(what +
                       ", but part of the soil's surface lies inside the mesh, and no condition names it, so no rain "
                       "would reach it. Name mpm::free_surface too");
  }
}

template std::vector<Outlet<2>> outlets(const StagePlan<2>&, const Surface<2>&, const std::string&, const std::string&,
                                        const Origin&);
template std::vector<Outlet<3>> outlets(const StagePlan<3>&, const Surface<3>&, const std::string&, const std::string&,
                                        const Origin&);
template void check_rain(const StagePlan<2>&, const Surface<2>&, const std::vector<Outlet<2>>&, const std::string&,
                         bool, const Origin&);
template void check_rain(const StagePlan<3>&, const Surface<3>&, const std::vector<Outlet<3>>&, const std::string&,
                         bool, const Origin&);

}  // namespace wetfront::mpm
