#include "mpm/grid/column_vector.h"
#include "mpm/skeleton/skeleton_columns.h"
#include "mpm/two_velocity/over_cells.h"

#include <algorithm>
#include <cmath>

/// Water of the points of a moving body: what leaves their cells, and how those of one cell share it.
namespace wetfront::mpm {

/// Step VI: W_p -= dt (V_p/V_c) sum_i f_ci . w_i, over all cells of a group together; then no point may hold more than
/// its pores or less than the driest soil.
template <int dim>
void MovingLiquid<dim>::balance(double dt, bool as_printed) {
  const auto flux = axes<dim>(as_printed ? *w_.velocity : *w_.flux);
  const auto leaves = [&](const Block& block) {
    const LiquidBlock<dim>& sums = blocks_[place(block)];
    return sums.part * outflow(block, flux) * (as_printed ? sums.water / sums.volume : 1.0);
  };
  over_cells([&](std::span<const Block> blocks, Found&) {
    for (const Block& block : blocks) {
      const LiquidBlock<dim>& sums = blocks_[place(block)];
      if (sums.group >= 0) continue;
      const double out = dt * leaves(block);
      drain({&block, 1}, out / sums.volume, (sums.water - out) / sums.pores);
    }
  });
  for (std::size_t g = 0; g < group_count_; ++g) {
    const LiquidGroup& group = groups_[g];
    double out = 0;
    members_.clear();
    for (std::size_t at : group.blocks) {
      const int soil = static_cast<int>(at / cells_);
      const std::size_t cell = cell_of(at);
      members_.push_back({cell, plan_.fields.grid.cell_nodes_of(cell), plan_.fields.points.first_slot(cell, soil),
                          plan_.fields.points.count_of_cell()[at], soil});
      out += dt * leaves(members_.back());
    }
    drain(members_, out / group.volume, (group.water - out) / group.pores);
  }
}

/// Takes `per_volume` from the points of a cell or group and lets them share: `content` is what they hold together,
/// water over pores. Where that is saturated they all hold what their pressure says: contents of their own, a few
/// thousandths beyond, would bring hundreds of kPa into the next cell. Else what is beyond the bounds of a point goes
/// to the others, or comes from them.
template <int dim>
void MovingLiquid<dim>::drain(std::span<const Block> blocks, double per_volume, double content) const {
  const LiquidLaws& laws = laws_[static_cast<std::size_t>(blocks[0].soil)];
  const double full = laws.content.saturated(), per_density = 1 / laws.grain_density;
  double* water = (*points_.water)[0];
  const double *volume = (*points_.volume)[0], *mass = (*points_.mass)[0];
  // body(water, pores) gives the water that four points hold from now on; dead slots have no pores and hold none.
  const auto each_four = [&](const auto& body) {
    for (const Block& block : blocks)
      for (std::size_t q = block.first; q < block.first + block.count; q += lane_count) {
        const Lanes pores = load(volume + q) - load(mass + q) * per_density;
        store_live(body(load(water + q), pores, q), water + q, live_lanes(block.first + block.count - q));
      }
  };
  if (content >= full) {
    each_four([&](const Lanes&, const Lanes& pores, std::size_t) { return content * pores; });
    return;
  }
  Lanes surpluses(0.0), rooms(0.0), lacks(0.0), spares(0.0);
  const Lanes nothing(0.0);
  const double least = std::min(laws.driest, content);
  each_four([&](const Lanes& held, const Lanes& pores, std::size_t q) {
    const Lanes left = held - per_volume * load(volume + q), over = left - full * pores, above = left - least * pores;
    surpluses += max(over, nothing), rooms -= min(over, nothing);
    lacks -= min(above, nothing), spares += max(above, nothing);
    return left;
  });
  const double surplus = mpm::sum(surpluses), lack = mpm::sum(lacks);
  if (surplus > 0) {
    const double share = surplus / mpm::sum(rooms);
    each_four([&](const Lanes& held, const Lanes& pores, std::size_t) {
      const Lanes over = held - full * pores;
      return held - select(over > 0.0, over, over * share);
    });
  }
  if (lack > 0) {
    const double share = lack / mpm::sum(spares);
    each_four([&](const Lanes& held, const Lanes& pores, std::size_t) {
      const Lanes above = held - least * pores;
      return held - select(above < 0.0, above, above * share);
    });
  }
}

template void MovingLiquid<2>::balance(double, bool);
template void MovingLiquid<3>::balance(double, bool);

}  // namespace wetfront::mpm
