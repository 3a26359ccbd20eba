#include "mpm/two_velocity/moving_liquid.h"

#include "mpm/laws/soil_water.h"
#include "mpm/plan/long_zeros.h"
#include "mpm/two_velocity/over_cells.h"

#include <algorithm>
#include <cmath>

/// The two-velocity liquid of a moving body: what it holds (README.md section 3b). Pressures: moving_pressure.cpp; a
/// step: moving_step.cpp; its limit: moving_limit.cpp.
namespace wetfront::mpm {

template <int dim>
MovingLiquid<dim>::MovingLiquid(StagePlan<dim>& plan, TwoVelocityWater<dim>& water, const PointColumns& points,
                                Vector<dim> weight)
    : plan_(plan),
      w_(water),
      points_(points),
      weight_(weight),
      body_(plan),
      cells_(plan.fields.grid.cell_count()),
      geometry_(cell_geometry(plan.fields.grid)),
      faces_(geometry_.size()),
      cells_at_(plan.fields.grid.node_count() + 1),
      blocks_(plan.fields.grid.cell_count() * plan.problem.soils.size()),
      team_(plan.problem.threads),
      chunks_(plan.fields.grid.cell_count(), plan.fields.grid.node_count(),
              [&grid = plan.fields.grid](std::size_t cell) {
                return std::vector<int>(grid.cell_nodes_of(cell), grid.cell_nodes_of(cell) + cell_nodes<dim>);
              }),
      found_(chunks_.size() * plan.problem.soils.size()),
      shares_(blocks_.size()),
      nodes_(plan.fields.grid.node_count()),
      gifts_(plan.fields.grid.node_count()),
      solid_at_(plan.fields.grid.node_count()),
      decided_(plan.fields.grid.node_count()),
      drag_(plan.fields.grid.node_count()),
      falls_(plan.fields.grid.node_count()),
      full_(plan.fields.grid.node_count()),
      all_(plan.fields.grid.node_count()) {
  const auto gather = [](const auto& values) { gather_pages(values.data(), values.size() * sizeof(values[0])); };
  gather(geometry_), gather(blocks_), gather(shares_), gather(nodes_), gather(gifts_);
  gather(solid_at_), gather(decided_), gather(drag_), gather(falls_), gather(full_), gather(all_), gather(faces_);
  for (auto& axis : back_) axis.resize(nodes_.size()), gather(axis);
  find_cells_at_nodes();
  for (std::size_t cell = 0; cell < cells_; ++cell) faces_[cell] = faces_of(cell, true);
  whole_faces_ = faces_;
  for (const Soil& soil : plan.problem.soils) {
    const TabulatedSoilWater laws = tabulated_soil_water(soil, *plan.problem.water);
    laws_.push_back({TabulatedContent(laws.curve, plan.problem.water->bulk_modulus), laws.permeability,
                     laws.saturated_mobility, soil.grain_density, laws.curve.pressure_scale(), 0});
    laws_.back().driest = laws_.back().content.value(-1e3 * laws_.back().pressure_scale);
  }
}

template <int dim>
void MovingLiquid<dim>::sum() {
  if (body_.update()) {
    for (std::size_t cell : body_.changed())
      for (int i = 0; i < cell_nodes<dim>; ++i)
        find_extents(static_cast<std::size_t>(plan_.fields.grid.cell_nodes_of(cell)[i]));
    find_border();
  }
  if (version_ != plan_.fields.points.version()) {
    chunks_.update(plan_.fields.points, static_cast<int>(laws_.size()));
    version_ = plan_.fields.points.version();
  }
  for (int i : body_.nodes()) nodes_[static_cast<std::size_t>(i)] = {};
  over_cells([this](std::span<const Block> blocks, Found& found) { sum_cells(blocks, found); });
  stored_ = held_ = 0;
  for (const Found& found : found_) {
    if (found.burst != Found::none) {
      const LiquidBlock<dim>& sums = blocks_[found.burst];
      pressure_at(laws_of(found.burst), sums.water / sums.pores, sums.centre, cell_of(found.burst));
    }
    stored_ += found.stored;
    held_ += found.held;
  }
  if (laws_.size() > 1) find_parts();
  group_slivers();
  open_faces();
  share_pressures();
  finish_nodes();
}

/// Sums over points of cells to the cells and their nodes; inside the body pressures too. By the batch: the pressures
/// of cells are found one after the other, so that their chains of operations overlap.
template <int dim>
void MovingLiquid<dim>::sum_cells(std::span<const Block> blocks, Found& found) {
  constexpr std::size_t batch = 16;
  found = {};
  std::array<Shares, batch> shares;
  LinearShape<dim> shape(plan_.fields.grid);
  for (; !blocks.empty(); blocks = blocks.subspan(std::min(batch, blocks.size()))) {
    const auto some = blocks.first(std::min(batch, blocks.size()));
    const LiquidLaws& laws = laws_[static_cast<std::size_t>(some[0].soil)];
    for (std::size_t k = 0; k < some.size(); ++k) {
      sum_points(some[k], shape, laws, shares[k]);
      found.held += blocks_[place(some[k])].water;
      if (body_.is_near_surface(some[k].cell)) shares_[place(some[k])] = shares[k];
    }
    for (const Block& block : some)
      if (!body_.is_near_surface(block.cell)) find_pressure(block, laws, found);
    for (std::size_t k = 0; k < some.size(); ++k) give_pressure(some[k], shares[k]);
  }
}

namespace {

/// Adds four numbers that lie one after the other.
[[gnu::always_inline]] inline void add(const Lanes& value, double* to) {
  store(load(to) + value, to);
}

}  // namespace

/// Sums of V, W, W (v_l - v_s) over a cell's points to its nodes, and what the cell itself holds.
template <int dim>
void MovingLiquid<dim>::sum_points(const Block& block, LinearShape<dim>& shape, const LiquidLaws& laws, Shares& share) {
  shape.enter(block);
  // Per node: V, W and W (v_l - v_s), as LiquidNode holds them.
  constexpr int values = 2 + dim;
  std::array<std::array<Lanes, cell_nodes<dim> / lane_count>, values> sums_of{};
  Lanes first_moment(0.0);  // sum V x (per axis), then mass
  const double *volume = (*points_.volume)[0], *wet = (*points_.water)[0], *mass = (*points_.mass)[0];
  typename LinearShape<dim>::Stencil at;
  for (std::size_t q = block.first; q < block.first + block.count; q += lane_count) {
    std::array<Lanes, dim> x;
    for (int a = 0; a < dim; ++a) x[a] = load((*points_.position)[a] + q);
    shape.values(x, at);
    const Lanes v = load(volume + q), w = load(wet + q);
    std::array<Lanes, 4> weigh{v, w, w, w};  // 2-D: the four values of a node
    std::array<Lanes, 3> moment{}, flow{};
    for (int a = 0; a < dim; ++a) {
      flow[a] = w * (load((*points_.velocity)[a] + q) - load((*points_.solid_velocity)[a] + q));
      moment[a] = v * x[a];
    }
    first_moment += mpm::sums(moment[0], moment[1], moment[2], load(mass + q));
    if constexpr (dim == 2) {
      weigh[2] = flow[0], weigh[3] = flow[1];
      each<4>([&](auto i) __attribute__((always_inline)) {
        const Lanes& n = at.value[i];
        sums_of[i][0] += mpm::sums(weigh[0] * n, weigh[1] * n, weigh[2] * n, weigh[3] * n);
      });
    } else {
      for (int g = 0; g < cell_nodes<dim> / lane_count; ++g)
        for (int k = 0; k < values; ++k) {
          const Lanes& by = k == 0 ? v : k == 1 ? w : flow[static_cast<std::size_t>(k - 2)];
          const Lanes* n = &at.value[static_cast<std::size_t>(lane_count * g)];
          sums_of[static_cast<std::size_t>(k)][static_cast<std::size_t>(g)] +=
              mpm::sums(by * n[0], by * n[1], by * n[2], by * n[3]);
        }
    }
  }
  double moments[lane_count];
  store(first_moment, moments);
  LiquidBlock<dim>& sums = blocks_[place(block)];
  if constexpr (dim == 2) {
    Lanes whole(0.0);
    each<4>([&](auto i) __attribute__((always_inline)) {
      const Lanes& node = sums_of[i][0];
      add(node, &nodes_[static_cast<std::size_t>(block.nodes[i])].volume);
      share[i] = node[0];
      whole += node;
    });
    sums.volume = whole[0], sums.water = whole[1];
  } else {
    double all[values][cell_nodes<dim>];
    for (std::size_t k = 0; k < values; ++k)
      for (std::size_t g = 0; g < cell_nodes<dim> / lane_count; ++g) store(sums_of[k][g], all[k] + lane_count * g);
    sums.volume = sums.water = 0;
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      LiquidNode<dim>& node = nodes_[static_cast<std::size_t>(block.nodes[i])];
      node.volume += all[0][i];
      node.water += all[1][i];
      for (int a = 0; a < dim; ++a) node.momentum[a] += all[2 + a][i];
      share[i] = all[0][i];
      sums.volume += all[0][i];
      sums.water += all[1][i];
    }
  }
  const double per_volume = 1 / sums.volume;
  for (int a = 0; a < dim; ++a) sums.centre[a] = moments[a] * per_volume;
  sums.pores = sums.volume - moments[3] / laws.grain_density;
  find_push(block, shape, share, sums);
}

/// Of a cell inside the body.
template <int dim>
void MovingLiquid<dim>::find_pressure(const Block& block, const LiquidLaws& laws, Found& found) {
  LiquidBlock<dim>& sums = blocks_[place(block)];
  sums.group = -1;
  sums.fill = 1;
  const double content = sums.water / sums.pores, p = laws.content.pressure_of(content);
  if (!explains(p) && found.burst == Found::none) found.burst = place(block);
  found.stored += sums.pores * take_pressure(place(block), p, content, laws);
}

/// What a cell brings to its nodes once its pressure is known; at the surface that comes later.
template <int dim>
void MovingLiquid<dim>::give_pressure(const Block& block, const Shares& share) {
  const LiquidBlock<dim>& sums = blocks_[place(block)];
  const bool inside = !body_.is_near_surface(block.cell);
  const double pressure = inside ? sums.pressure : 0, mobility = inside ? sums.mobility : 0;
  if constexpr (dim == 2) {
    const double values[4] = {pressure, sums.centre[0], sums.centre[1], mobility};
    const Lanes given = load(values);
    for (int i = 0; i < 4; ++i) add(given * share[i], &nodes_[static_cast<std::size_t>(block.nodes[i])].pressure);
  } else {
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      LiquidNode<dim>& node = nodes_[static_cast<std::size_t>(block.nodes[i])];
      node.pressure += share[i] * pressure;
      for (int a = 0; a < dim; ++a) node.centre[a] += share[i] * sums.centre[a];
      node.mobility += share[i] * mobility;
    }
  }
}

/// sum_p V_p grad N_i. In an affine cell dN_i/dxi_b is +-1/2 times the product of the other axes' factors, which is
/// N_i plus N of the partner along b.
template <int dim>
void MovingLiquid<dim>::find_push(const Block& block, const LinearShape<dim>& shape, const Shares& share,
                                  LiquidBlock<dim>& sums) const {
  if (plan_.problem.skeleton.locking == LockingRemedy::b_bar) {
    // The gradient that the skeleton's change of volume has: what p works on.
    if constexpr (dim == 2) {
      const auto mean = shape.mean_gradients();
      for (int a = 0; a < dim; ++a) store(mean[a] * sums.volume, sums.push[a].data());
    } else {
      std::array<Vector<dim>, cell_nodes<dim>> mean;
      shape.mean_gradients(mean);
      for (int i = 0; i < cell_nodes<dim>; ++i)
        for (int a = 0; a < dim; ++a) sums.push[a][i] = sums.volume * mean[i][a];
    }
    return;
  }
  if (!plan_.fields.grid.affine(block.cell)) return push_of_crooked_cell(block, sums);
  constexpr auto partner = [](int i, int b) {
    for (int j = 0; j < cell_nodes<dim>; ++j) {
      bool is = node_sign(j, b) != node_sign(i, b);
      for (int a = 0; a < dim; ++a) is = is && (a == b || node_sign(j, a) == node_sign(i, a));
      if (is) return j;
    }
    return i;
  };
  const auto& map = plan_.fields.grid.map(block.cell);
  for (int i = 0; i < cell_nodes<dim>; ++i) {
    Vector<dim> push{};
    for (int b = 0; b < dim; ++b) {
      const double slope = 0.5 * node_sign(i, b) * (share[i] + share[partner(i, b)]);
      for (int a = 0; a < dim; ++a) push[a] += map.inverse[b][a] * slope;
    }
    for (int a = 0; a < dim; ++a) sums.push[a][i] = push[a];
  }
}

template <int dim>
void MovingLiquid<dim>::push_of_crooked_cell(const Block& block, LiquidBlock<dim>& sums) const {
  LinearShape<dim> shape(plan_.fields.grid);
  shape.enter(block);
  typename LinearShape<dim>::Stencil at;
  std::array<std::array<Lanes, dim>, cell_nodes<dim>> push{};
  for (std::size_t q = block.first; q < block.first + block.count; q += lane_count) {
    std::array<Lanes, dim> x;
    for (int a = 0; a < dim; ++a) x[a] = load((*points_.position)[a] + q);
    shape.all(x, at);
    const Lanes v = load((*points_.volume)[0] + q);
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a)
        for (int b = 0; b < dim; ++b) push[i][a] += v * (at.slope[i][b] * at.inverse[b][a]);
  }
  for (int i = 0; i < cell_nodes<dim>; ++i)
    for (int a = 0; a < dim; ++a) sums.push[a][i] = mpm::sum(push[i][a]);
}

/// Water compressed by a tenth or drawn to half its density: no soil is there, the scheme has blown up.
template <int dim>
bool MovingLiquid<dim>::explains(double pressure) const {
  const double K = plan_.problem.water->bulk_modulus;
  return pressure < 0.1 * K && pressure > -0.5 * K;
}

/// Gives e(p).
template <int dim>
double MovingLiquid<dim>::take_pressure(std::size_t place, double pressure, double content, const LiquidLaws& laws) {
  LiquidBlock<dim>& sums = blocks_[place];
  const ValueAndSlope here = laws.content.value_and_slope(pressure);
  sums.pressure = pressure;
  sums.content = content;
  sums.slope = here.slope;
  sums.mobility = laws.mobility(pressure);
  sums.saturation = laws.content.saturation(content, pressure);
  return here.value;
}

template class MovingLiquid<2>;
template class MovingLiquid<3>;

}  // namespace wetfront::mpm
