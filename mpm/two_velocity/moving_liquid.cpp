#include "mpm/two_velocity/moving_liquid.h"

#include "mpm/laws/soil_water.h"

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
      geometry_(cell_geometry(plan.fields.grid)),
      blocks_(plan.fields.grid.cell_count() * plan.problem.soils.size()),
      shares_(blocks_.size()),
      nodes_(plan.fields.grid.node_count()),
      back_(plan.fields.grid.node_count()),
      towards_(plan.fields.grid.node_count()),
      solid_at_(plan.fields.grid.node_count()),
      decided_(plan.fields.grid.node_count()),
      drag_(plan.fields.grid.node_count()),
      full_(plan.fields.grid.node_count()),
      all_(plan.fields.grid.node_count()) {
  // As cells that were near the surface get theirs back: a continued run has the same bits.
  for (std::size_t cell = 0; cell < geometry_.size(); ++cell) set_faces(cell, true);
  for (const Soil& soil : plan.problem.soils) {
    const TabulatedSoilWater laws = tabulated_soil_water(soil, *plan.problem.water);
    laws_.push_back({TabulatedContent(laws.curve, plan.problem.water->bulk_modulus), laws.permeability,
                     laws.saturated_mobility, soil.grain_density, laws.curve.pressure_scale(), 0});
    laws_.back().driest = laws_.back().content.value(-1e3 * laws_.back().pressure_scale);
  }
}

/// What depends on which cells hold points.
template <int dim>
void MovingLiquid<dim>::begin_body() {
  const Grid<dim>& grid = plan_.fields.grid;
  w_.walls.find(grid, body_);
  std::fill(full_.begin(), full_.end(), 0.0);
  std::fill(all_.begin(), all_.end(), 0.0);
  for (std::size_t cell : body_.cells())
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      const auto node = static_cast<std::size_t>(grid.cell_nodes_of(cell)[i]);
      all_[node] += geometry_[cell].extent[i];
      if (!body_.at_surface(cell)) full_[node] += geometry_[cell].extent[i];
    }
  hanging_.clear();
  rained_.clear();
  for (const auto& outer : body_.outer()) {
    const auto local = local_face<dim>(outer.face);
    const auto integrals = Faces<dim>::integrals(grid, outer.cell, outer.face);
    double size = 0;
    Vector<dim> whole{};
    for (const auto& part : integrals)
      for (int a = 0; a < dim; ++a) whole[a] += part[a];
    size = length<dim>(whole);
    for (std::size_t k = 0; k < local.size(); ++k) {
      const int node = grid.cell_nodes_of(outer.cell)[local[k]];
      Hanging hanging{node, integrals[k]};
      for (double& component : hanging.force) component *= dot<dim>(weight_, grid.node(node));
      hanging_.push_back(hanging);
      if (!outer.rains.empty())
        rained_.push_back({node, outer.cell, integrals[k], geometry_[outer.cell].volume / size});
    }
  }
  for (auto& listener : listeners_) listener();
}

template <int dim>
void MovingLiquid<dim>::sum() {
  if (body_.update()) begin_body();
  const LiquidNode<dim> nothing{};
  for (int i : body_.nodes()) nodes_[static_cast<std::size_t>(i)] = nothing;
  stored_ = held_ = 0;
  LinearShape<dim> shape(plan_.fields.grid);
  for (const Block& block : plan_.fields.points.blocks())
    sum_block(block, shape, laws_[static_cast<std::size_t>(block.soil)]);
  if (laws_.size() > 1) find_parts();
  group_slivers();
  open_faces();
  share_pressures();
  finish_nodes();
}

/// Of a cell: sums over its points to the cell and its nodes; inside the body its pressure too.
template <int dim>
void MovingLiquid<dim>::sum_block(const Block& block, LinearShape<dim>& shape, const LiquidLaws& laws) {
  shape.enter(block);
  NodeSums<dim> share, water;
  std::array<NodeSums<dim>, dim> momentum;
  Lanes first_moment{};  // sum V x (per axis), then mass
  const std::size_t end = block.first + block.count;
  const double *volume = (*points_.volume)[0], *wet = (*points_.water)[0], *mass = (*points_.mass)[0];
  typename LinearShape<dim>::Stencil at;
  for (std::size_t q = block.first; q < end; q += lane_count) {
    std::array<Lanes, dim> x;
    for (int a = 0; a < dim; ++a) x[a] = load((*points_.position)[a] + q);
    shape.values(x, at);
    const Lanes v = load(volume + q), w = load(wet + q);
    share.add(v, at.value);
    water.add(w, at.value);
    std::array<Lanes, 3> moment{};
    for (int a = 0; a < dim; ++a) {
      momentum[a].add(w * (load((*points_.velocity)[a] + q) - load((*points_.solid_velocity)[a] + q)), at.value);
      moment[a] = v * x[a];
    }
    first_moment += mpm::sums(moment[0], moment[1], moment[2], load(mass + q));
  }
  double shares[cell_nodes<dim>], waters[cell_nodes<dim>], momenta[dim][cell_nodes<dim>];
  share.copy_to(shares);
  water.copy_to(waters);
  for (int a = 0; a < dim; ++a) momentum[a].copy_to(momenta[a]);

  LiquidBlock<dim>& sums = blocks_[place(block)];
  sums.volume = sums.water = 0;
  for (int i = 0; i < cell_nodes<dim>; ++i) {
    sums.volume += shares[i];
    sums.water += waters[i];
  }
  const double per_volume = 1 / sums.volume;
  for (int a = 0; a < dim; ++a) sums.centre[a] = first_moment[a] * per_volume;
  sums.pores = sums.volume - first_moment[3] / laws.grain_density;
  find_push(block, shape, shares, sums);
  held_ += sums.water;
  const bool inside = !body_.is_near_surface(block.cell);
  if (inside) {
    sums.group = -1;
    sums.fill = 1;
    const double content = sums.water / sums.pores;
    take_pressure(place(block), pressure_at(laws, content, sums.centre, block.cell), content, laws);
    stored_ += sums.pores * laws.content.value(sums.pressure);
  } else {
    std::copy(std::begin(shares), std::end(shares), shares_[place(block)].begin());
  }
  for (int i = 0; i < cell_nodes<dim>; ++i) {
    LiquidNode<dim>& node = nodes_[static_cast<std::size_t>(block.nodes[i])];
    node.volume += shares[i];
    node.water += waters[i];
    for (int a = 0; a < dim; ++a) {
      node.momentum[a] += momenta[a][i];
      node.centre[a] += shares[i] * sums.centre[a];
    }
    node.pressure += inside ? shares[i] * sums.pressure : 0.0;
    node.mobility += inside ? shares[i] * sums.mobility : 0.0;
  }
}

/// sum_p V_p grad N_i. In an affine cell dN_i/dxi_b is +-1/2 times the product of the other axes' factors, which is
/// N_i plus N of the partner along b.
template <int dim>
void MovingLiquid<dim>::find_push(const Block& block, const LinearShape<dim>& shape,
                                  const double (&share)[cell_nodes<dim>], LiquidBlock<dim>& sums) const {
  if (plan_.problem.skeleton.locking == LockingRemedy::b_bar) {
    // The gradient that the skeleton's change of volume has: what p works on.
    std::array<Vector<dim>, cell_nodes<dim>> mean;
    shape.mean_gradients(mean);
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a) sums.push[i][a] = sums.volume * mean[i][a];
    return;
  }
  if (!plan_.fields.grid.affine(block.cell)) return push_of_crooked_cell(block, shape, sums);
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
    sums.push[i] = push;
  }
}

template <int dim>
void MovingLiquid<dim>::push_of_crooked_cell(const Block& block, const LinearShape<dim>& shape,
                                             LiquidBlock<dim>& sums) const {
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
    for (int a = 0; a < dim; ++a) sums.push[i][a] = mpm::sum(push[i][a]);
}

/// Of cells with two soils: the part of each block.
template <int dim>
void MovingLiquid<dim>::find_parts() {
  for (const Block& block : plan_.fields.points.blocks()) {
    double all = 0;
    for (std::size_t soil = 0; soil < laws_.size(); ++soil)
      if (plan_.fields.points.count_of_cell()[place(block.cell, static_cast<int>(soil))] > 0)
        all += blocks_[place(block.cell, static_cast<int>(soil))].volume;
    blocks_[place(block)].part = blocks_[place(block)].volume / all;
  }
}

template <int dim>
double MovingLiquid<dim>::pressure_at(const LiquidLaws& laws, double content, const Vector<dim>& centre,
                                      std::size_t cell) const {
  const double p = laws.content.pressure_of(content), K = plan_.problem.water->bulk_modulus;
  // Water compressed by a tenth or drawn to half its density: no soil is there, the scheme has blown up.
  if (p < 0.1 * K && p > -0.5 * K) return p;
  throw StepFailed("the two-velocity scheme has blown up: cell " + std::to_string(cell) + " at " +
                   place_text<dim>(centre) + " holds " + std::to_string(content) +
                   " of its pores, which no pressure explains" + step_against_limit<dim>(plan_, w_));
}

template <int dim>
void MovingLiquid<dim>::take_pressure(std::size_t place, double pressure, double content, const LiquidLaws& laws) {
  LiquidBlock<dim>& sums = blocks_[place];
  sums.pressure = pressure;
  sums.content = content;
  sums.mobility = laws.mobility(pressure);
  sums.saturation = laws.content.saturation(content, pressure);
}

template class MovingLiquid<2>;
template class MovingLiquid<3>;

}  // namespace wetfront::mpm
