#include "mpm/grid/column_vector.h"
#include "mpm/two_velocity/moving_liquid.h"

#include <algorithm>
#include <cmath>

/// Water of the points of a moving body: what leaves their cells, and how those of one cell share it.
namespace wetfront::mpm {

/// Step VI: W_p -= dt (V_p/V_c) sum_i f_ci . w_i, over all cells of a group together; then no point may hold more than
/// its pores or less than the driest soil.
template <int dim>
void MovingLiquid<dim>::balance(double dt, bool as_printed) {
  const auto flux = axes<dim>(as_printed ? *w_.velocity : *w_.flux);
  const auto leaves = [&](std::size_t at) {
    const LiquidBlock<dim>& sums = blocks_[at];
    return sums.part * outflow(cell_of(at), flux) * (as_printed ? sums.water / sums.volume : 1.0);
  };
  for (const Block& block : plan_.fields.points.blocks()) {
    const std::size_t at = place(block);
    const LiquidBlock<dim>& sums = blocks_[at];
    if (sums.group >= 0) continue;
    const double out = dt * leaves(at);
    drain({&block, 1}, out / sums.volume, (sums.water - out) / sums.pores);
  }
  for (std::size_t g = 0; g < group_count_; ++g) {
    const LiquidGroup& group = groups_[g];
    double out = 0;
    members_.clear();
    for (std::size_t at : group.blocks) {
      const int soil = static_cast<int>(at / geometry_.size());
      const std::size_t cell = cell_of(at);
      members_.push_back(
          {cell, nullptr, plan_.fields.points.first_slot(cell, soil), plan_.fields.points.count_of_cell()[at], soil});
      out += dt * leaves(at);
    }
    drain(members_, out / group.volume, (group.water - out) / group.pores);
  }
}

/// Takes `per_volume` from the points of a cell or group and lets them share: `content` is what they hold together,
/// water over pores. Where that is saturated they all hold what their pressure says: contents of their own, a few
/// thousandths beyond, would bring hundreds of kPa into the next cell. Else what is beyond the bounds of a point goes
/// to the others, or comes from them.
template <int dim>
void MovingLiquid<dim>::drain(std::span<const Block> blocks, double per_volume, double content) {
  const LiquidLaws& laws = laws_[static_cast<std::size_t>(blocks[0].soil)];
  const double full = laws.content.saturated(), per_density = 1 / laws.grain_density;
  double* water = (*points_.water)[0];
  const double *volume = (*points_.volume)[0], *mass = (*points_.mass)[0];
  const auto each_point = [blocks](const auto& body) {
    for (const Block& block : blocks)
      for (std::size_t q = block.first; q < block.first + block.count; ++q) body(q);
  };
  const auto pores = [&](std::size_t q) { return volume[q] - mass[q] * per_density; };
  if (content >= full) {
    each_point([&](std::size_t q) { water[q] = content * pores(q); });
    return;
  }
  double surplus = 0, room = 0, lack = 0, spare = 0;
  const double least = std::min(laws.driest, content);
  each_point([&](std::size_t q) {
    water[q] -= per_volume * volume[q];
    const double over = water[q] - full * pores(q), above = water[q] - least * pores(q);
    (over > 0 ? surplus : room) += std::abs(over);
    (above < 0 ? lack : spare) += std::abs(above);
  });
  if (surplus > 0)
    each_point([&](std::size_t q) {
      const double over = water[q] - full * pores(q);
      water[q] -= over > 0 ? over : over * (surplus / room);
    });
  if (lack > 0)
    each_point([&](std::size_t q) {
      const double above = water[q] - least * pores(q);
      water[q] -= above < 0 ? above : above * (lack / spare);
    });
}

template void MovingLiquid<2>::balance(double, bool);
template void MovingLiquid<3>::balance(double, bool);

}  // namespace wetfront::mpm
