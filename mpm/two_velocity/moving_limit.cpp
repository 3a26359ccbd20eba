#include "mpm/grid/column_vector.h"
#include "mpm/laws/linear_elastic.h"
#include "mpm/two_velocity/over_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

/// The step limit of skeleton and liquid together (README.md section 6b).
namespace wetfront::mpm {

template <int dim>
double MovingLiquid<dim>::limit(int soil, double steps_ahead, double growth, double last_step) {
  const LiquidLaws& laws = laws_[static_cast<std::size_t>(soil)];
  const double modulus =
      LinearElastic(*plan_.problem.soils[static_cast<std::size_t>(soil)].elastic).constrained_modulus();
  find_resistance();
  for (Found& found : found_) found.worst = 0;
  const double ahead = steps_ahead * growth * last_step;
  over_cells([&](std::span<const Block> blocks, Found& found) {
    for (const Block& block : blocks)
      if (block.soil == soil) limit_of(block, laws, modulus, ahead, found);
  });
  double worst = 0;
  for (const Found& found : found_) worst = std::max(worst, found.worst);
  return worst > 0 ? 1 / worst : std::numeric_limits<double>::infinity();
}

/// What the limit takes from the nodes: the drag that rules there (the least of a cell where it is implicit, its
/// largest, with a minus, where it is explicit), and rain.
template <int dim>
void MovingLiquid<dim>::find_resistance() {
  const bool is_explicit = plan_.stage.liquid == LiquidScheme::explicit_drag;
  const double *content = (*w_.content)[0], *mobility = (*w_.mobility)[0];
  const double *rain = (*w_.rain_rate)[0], *volume = (*w_.volume)[0];
  const double density = is_explicit ? -w_.density : w_.density;
  over_node_runs([&](const NodeRun& run) {
    double *drag = drag_.data(), *falls = falls_.data();
#pragma GCC ivdep
    for (std::size_t i = run.first; i < run.last; ++i) {
      drag[i] = content[i] / (mobility[i] * density);
      falls[i] = rain[i] / volume[i];
    }
  });
  // Where walls leave no direction nothing is dragged.
  for (std::size_t k = 0; k < w_.walls.size(); ++k)
    if (const std::size_t i = w_.walls.node(k); w_.walls.closed(i))
      drag_[i] = is_explicit ? 0 : std::numeric_limits<double>::infinity();
}

/// Of one block; `ahead` is the time that is looked ahead [s].
template <int dim>
void MovingLiquid<dim>::limit_of(const Block& block, const LiquidLaws& laws, double modulus, double ahead,
                                 Found& found) const {
  // What mapping to points and back leaves of the stiffest mode at least (README.md section 6b).
  constexpr double mapped = 0.5;
  // A cell that goes in and out of saturation meets a stiffness 1e4 times greater as a wall: bounced off it with steps
  // near the limit it comes back with more energy on the mean (README.md section 6b); measured, none from 0.6 on.
  constexpr double impact = 0.7;
  const LiquidBlock<dim>& sums = blocks_[place(block)];
  const CellGeometry<dim>& geometry = geometry_[block.cell];
  const CellNodes<dim> nodes(block.nodes);
  Lanes out(0.0), closed(0.0), rain(0.0), drag(std::numeric_limits<double>::infinity());
  for (int a = 0; a < dim; ++a) {
    const auto& faces = faces_[block.cell][static_cast<std::size_t>(a)];
    out += product(faces, nodes.of((*w_.flux)[a]));
    closed -= product(faces, nodes.of((*w_.solid_velocity)[a]));
  }
  for (const Lanes& four : nodes.of(falls_.data())) rain += four;
  for (const Lanes& four : nodes.of(drag_.data())) drag = min(drag, four);
  const Lanes all_of = mpm::sums(out, closed, rain, Lanes(0.0));
  const double per_pores = 1 / sums.pores, per_volume = 1 / sums.volume, e = sums.content;
  const double wet = sums.water * per_volume;
  const double rate = per_pores * (std::max(std::abs(all_of[0]), all_of[2] * sums.volume / cell_nodes<dim>) +
                                   std::max(0.0, static_cast<double>(all_of[1])) * wet);
  double slope = sums.slope;
  const double later = e + ahead * rate;
  // Within a thousandth of the curve's scale of p = 0 a strain of 1e-6 saturates the cell.
  if (sums.pressure > -1e-3 * laws.pressure_scale || later >= laws.content.saturated())
    slope = std::min(slope, laws.content.saturated() / plan_.problem.water->bulk_modulus);
  else
    slope = std::min(slope, laws.content.slope_near(later));
  CoupledCell cell;
  const double n = sums.pores * per_volume, per_storage = 1 / (n * slope);
  const double all = sums.group < 0 ? sums.volume : groups_[static_cast<std::size_t>(sums.group)].volume;
  const double stiffness = mapped * geometry.stiffness, thinness = std::max(1.0, geometry.volume / all);
  // What is decided at rained nodes is restored after mapping: nothing of it is lost there.
  const double kept = !rained_.empty() && body_.is_open(block.cell) ? geometry.stiffness : stiffness;
  const double s = sums.saturation, k = kept * thinness * per_storage;
  cell.liquid = wet * w_.density;
  cell.mixture = (1 - n) * laws.grain_density + cell.liquid;
  cell.k11 = stiffness * dim * modulus + k * s * s;
  cell.k12 = k * s * wet;
  cell.k22 = k * wet * wet;
  const double least = std::experimental::hmin(drag);
  cell.drag = std::isfinite(least) ? least : 0;
  // `worst` in units of this cell's own limit.
  const double share = near_kink(sums, rate * ahead, laws) ? impact : 1;
  if (!cell.stable(found.worst * share)) found.worst = std::max(found.worst, cell.critical() / share);
}

/// The content may pass saturation within `change` of itself, either way.
template <int dim>
bool MovingLiquid<dim>::near_kink(const LiquidBlock<dim>& sums, double change, const LiquidLaws& laws) const {
  return std::abs(sums.content - laws.content.saturated()) < change;
}

template double MovingLiquid<2>::limit(int, double, double, double);
template double MovingLiquid<3>::limit(int, double, double, double);

}  // namespace wetfront::mpm
