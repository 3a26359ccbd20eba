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
  const double *content = (*w_.content)[0], *mobility = (*w_.mobility)[0];
  over_nodes([&](std::size_t i) { drag_[i] = content[i] / (mobility[i] * w_.density); });
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

/// Of one block; `ahead` is the time that is looked ahead [s].
template <int dim>
void MovingLiquid<dim>::limit_of(const Block& block, const LiquidLaws& laws, double modulus, double ahead,
                                 Found& found) const {
  // What mapping to points and back leaves of the stiffest mode at least (README.md section 6b).
  constexpr double mapped = 0.5;
  // A cell that goes in and out of saturation meets a stiffness 1e4 times greater as a wall: bounced off it with steps
  // near the limit it comes back with more energy on the mean (README.md section 6b); measured, none from 0.6 on.
  constexpr double impact = 0.7;
  const bool is_explicit = plan_.stage.liquid == LiquidScheme::explicit_drag;
  const auto flux = axes<dim>(*w_.flux), closing = axes<dim>(*w_.solid_velocity);
  const double *rain = (*w_.rain_rate)[0], *volume = (*w_.volume)[0];
  const LiquidBlock<dim>& sums = blocks_[place(block)];
  const CellGeometry<dim>& geometry = geometry_[block.cell];
  double least = std::numeric_limits<double>::infinity(), most = 0, out = 0, closed = 0, falls = 0;
  for (int k = 0; k < cell_nodes<dim>; ++k) {
    const auto i = static_cast<std::size_t>(block.nodes[k]);
    for (int a = 0; a < dim; ++a) {
      out += geometry.faces[k][a] * flux[a][i];
      closed -= geometry.faces[k][a] * closing[a][i];
    }
    falls += rain[i] / volume[i];
    if (w_.walls.closed(i)) continue;
    least = std::min(least, drag_[i]);
    most = std::max(most, drag_[i]);
  }
  const double per_pores = 1 / sums.pores, e = sums.content;
  const double rate = per_pores * (std::max(std::abs(out), falls * sums.volume / cell_nodes<dim>) +
                                   std::max(0.0, closed) * sums.water / sums.volume);
  double slope = laws.content.slope(sums.pressure);
  const double saturated = laws.content.saturated() / plan_.problem.water->bulk_modulus;
  const double later = e + ahead * rate;
  // Within a thousandth of the curve's scale of p = 0 a strain of 1e-6 saturates the cell.
  if (sums.pressure > -1e-3 * laws.pressure_scale || later >= laws.content.saturated())
    slope = std::min(slope, saturated);
  else
    slope = std::min(slope, laws.content.slope(laws.content.pressure_near(later)));
  CoupledCell cell;
  const double n = sums.pores / sums.volume, wet = sums.water / sums.volume, per_storage = 1 / (n * slope);
  const double all = sums.group < 0 ? sums.volume : groups_[static_cast<std::size_t>(sums.group)].volume;
  const double fill = std::min(1.0, all / geometry.volume);
  // What is decided at rained nodes is restored after mapping: nothing of it is lost there.
  const double kept = !rained_.empty() && body_.is_open(block.cell) ? 1 : mapped;
  const double s = sums.saturation, k = kept * geometry.stiffness / fill;
  cell.liquid = wet * w_.density;
  cell.mixture = (1 - n) * laws.grain_density + cell.liquid;
  cell.k11 = mapped * geometry.stiffness * dim * modulus + k * s * s * per_storage;
  cell.k12 = k * s * wet * per_storage;
  cell.k22 = k * wet * wet * per_storage;
  cell.drag = is_explicit ? -most : std::isfinite(least) ? least : 0;
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
