#include "mpm/two_velocity/moving_liquid.h"

#include "mpm/laws/linear_elastic.h"
#include "mpm/laws/soil_water.h"
#include "mpm/skeleton/skeleton_columns.h"
#include "mpm/two_velocity/nodal_vector.h"

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {

namespace {

template <int dim>
std::array<double*, dim> axes(Column& column) {
  std::array<double*, dim> out;
  for (int a = 0; a < dim; ++a) out[a] = column[a];
  return out;
}

}  // namespace

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
      drag_(plan.fields.grid.node_count()),
      full_(plan.fields.grid.node_count()),
      all_(plan.fields.grid.node_count()) {
  for (const Soil& soil : plan.problem.soils) {
    const TabulatedSoilWater laws = tabulated_soil_water(soil, *plan.problem.water);
    laws_.push_back({TabulatedContent(laws.curve, plan.problem.water->bulk_modulus), laws.permeability,
                     laws.saturated_mobility, soil.grain_density, laws.curve.pressure_scale()});
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
      momentum[a].add(w * load((*points_.velocity)[a] + q), at.value);
      moment[a] = v * x[a];
    }
    first_moment += lane_sums(moment[0], moment[1], moment[2], load(mass + q));
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

/// Calls body(place) for every block in cells near the surface.
template <int dim>
template <class Body>
void MovingLiquid<dim>::near_surface(const Body& body) const {
  for (std::size_t cell : body_.near_surface())
    for (std::size_t soil = 0; soil < laws_.size(); ++soil) {
      const std::size_t at = place(cell, static_cast<int>(soil));
      if (plan_.fields.points.count_of_cell()[at] > 0) body(at);
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

/// Gives every cell at the surface that is filled by less than `least_fill` to the fullest cell across its faces that
/// holds the same soil.
template <int dim>
void MovingLiquid<dim>::group_slivers() {
  constexpr double least_fill = 0.5, nearly_full = 0.9;
  group_count_ = 0;
  near_surface([&](std::size_t at) {
    LiquidBlock<dim>& sums = blocks_[at];
    const std::size_t cell = cell_of(at);
    sums.group = -1;
    sums.fill = body_.at_surface(cell) ? std::min(1.0, sums.volume / sums.part / geometry_[cell].volume) : 1.0;
    // At a wall of the mesh a cell that has lost little more than its strain is full.
    if (!body_.is_open(cell) && sums.fill > nearly_full) sums.fill = 1;
  });
  near_surface([&](std::size_t at) {
    const std::size_t cell = cell_of(at), soil = at / geometry_.size();
    if (!body_.at_surface(cell) || blocks_[at].fill >= least_fill) return;
    int host = -1;
    double fullest = least_fill;
    for (int f = 0; f < cell_faces<dim>; ++f) {
      const int across = body_.faces().neighbour(cell, f);
      if (!body_.occupied(across)) continue;
      const std::size_t other = place(static_cast<std::size_t>(across), static_cast<int>(soil));
      if (plan_.fields.points.count_of_cell()[other] == 0 || blocks_[other].fill < fullest) continue;
      host = static_cast<int>(other);
      fullest = blocks_[other].fill;
    }
    if (host < 0) return;
    int& group = blocks_[static_cast<std::size_t>(host)].group;
    if (group < 0) {
      if (group_count_ == groups_.size()) groups_.emplace_back();
      group = static_cast<int>(group_count_++);
      groups_[static_cast<std::size_t>(group)].blocks.assign(1, static_cast<std::size_t>(host));
    }
    groups_[static_cast<std::size_t>(group)].blocks.push_back(at);
    blocks_[at].group = group;
  });
}

/// The face between two cells at the surface is open as far as they are filled, so that a sliver conducts along the
/// surface like the film it is. Both cells see the same opening: what leaves one enters the other.
template <int dim>
void MovingLiquid<dim>::open_faces() {
  for (std::size_t cell : narrowed_) set_faces(cell, true);
  narrowed_.assign(body_.surface_cells().begin(), body_.surface_cells().end());
  for (std::size_t cell : narrowed_) set_faces(cell, false);
}

template <int dim>
void MovingLiquid<dim>::set_faces(std::size_t cell, bool open) {
  auto& faces = geometry_[cell].faces;
  faces = {};
  for (int f = 0; f < cell_faces<dim>; ++f) {
    const int across = body_.faces().neighbour(cell, f);
    double part = 1;
    if (!open && body_.occupied(across) && body_.at_surface(static_cast<std::size_t>(across)))
      part = 0.5 * (fill_of(cell) + fill_of(static_cast<std::size_t>(across)));
    const auto local = local_face<dim>(f);
    const auto integrals = Faces<dim>::integrals(plan_.fields.grid, cell, f);
    for (std::size_t k = 0; k < local.size(); ++k)
      for (int a = 0; a < dim; ++a) faces[static_cast<std::size_t>(local[k])][a] += part * integrals[k][a];
  }
}

/// Pressures of the cells near the surface, one potential p - rho g.x in each group, and what they bring to the nodes.
template <int dim>
void MovingLiquid<dim>::share_pressures() {
  const Grid<dim>& grid = plan_.fields.grid;
  for (std::size_t g = 0; g < group_count_; ++g) {
    LiquidGroup& group = groups_[g];
    double pores = 0, water = 0;
    Vector<dim> centre{};
    group.volume = 0;
    for (std::size_t at : group.blocks) {
      const LiquidBlock<dim>& sums = blocks_[at];
      pores += sums.pores;
      water += sums.water;
      group.volume += sums.volume;
      for (int a = 0; a < dim; ++a) centre[a] += sums.volume * sums.centre[a];
    }
    for (double& component : centre) component /= group.volume;
    const LiquidLaws& laws = laws_of(group.blocks[0]);
    const double content = water / pores, p = pressure_at(laws, content, centre, cell_of(group.blocks[0]));
    const double potential = p - dot<dim>(weight_, centre);
    stored_ += pores * laws.content.value(p);
    for (std::size_t at : group.blocks) {
      take_pressure(at, potential + dot<dim>(weight_, blocks_[at].centre), content, laws);
      blocks_[at].saturation = laws.content.saturation(content, p);
    }
  }
  near_surface([&](std::size_t at) {
    LiquidBlock<dim>& sums = blocks_[at];
    const std::size_t cell = cell_of(at);
    if (sums.group < 0) {
      const LiquidLaws& laws = laws_of(at);
      const double content = sums.water / sums.pores;
      take_pressure(at, pressure_at(laws, content, sums.centre, cell), content, laws);
      stored_ += sums.pores * laws.content.value(sums.pressure);
    }
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      LiquidNode<dim>& node = nodes_[static_cast<std::size_t>(grid.cell_nodes_of(cell)[i])];
      node.pressure += shares_[at][i] * sums.pressure;
      node.mobility += shares_[at][i] * sums.mobility;
    }
  });
}

/// (nS)_i, p_i (mean of the cells, carried hydrostatically from their centres to the node), M_i (Simpson's mean of K
/// between centres of cells, the node between them).
template <int dim>
void MovingLiquid<dim>::finish_nodes() {
  double *volume = (*w_.volume)[0], *content = (*w_.content)[0], *pressure = (*w_.pressure)[0];
  double *mobility = (*w_.mobility)[0], *of_cells = (*w_.cell_mobility)[0];
  const auto offset = axes<dim>(*w_.offset);
  const bool one_soil = laws_.size() == 1;
  for (int index : body_.nodes()) {
    const auto i = static_cast<std::size_t>(index);
    const LiquidNode<dim>& node = nodes_[i];
    const double per_volume = 1 / node.volume;
    volume[i] = node.volume;
    content[i] = node.water * per_volume;
    double p = node.pressure * per_volume;
    for (int a = 0; a < dim; ++a) {
      offset[a][i] = plan_.fields.grid.node(index)[a] - node.centre[a] * per_volume;
      p += weight_[a] * offset[a][i];
    }
    pressure[i] = p;
    of_cells[i] = node.mobility * per_volume;
    mobility[i] = (one_soil ? of_cells[i] + 2 * laws_[0].mobility(p) : of_cells[i]) / 3;
  }
  if (!one_soil)
    for (const Block& block : plan_.fields.points.blocks()) {
      const LiquidLaws& laws = laws_[static_cast<std::size_t>(block.soil)];
      const LiquidBlock<dim>& sums = blocks_[place(block)];
      for (int k = 0; k < cell_nodes<dim>; ++k) {
        // The block's part in the node's volume by its whole volume: enough to weigh one soil against another.
        const auto i = static_cast<std::size_t>(block.nodes[k]);
        mobility[i] += 2.0 / 3 * sums.volume / cell_nodes<dim> / volume[i] * laws.mobility(pressure[i]);
      }
    }
  add_flow_volume();
}

/// V_i of the liquid's momentum: of inner cells all of it however their points lie, of cells at the surface the part
/// that is filled.
template <int dim>
void MovingLiquid<dim>::add_flow_volume() {
  const Grid<dim>& grid = plan_.fields.grid;
  double* flow = (*w_.flow_volume)[0];
  for (int i : body_.nodes()) flow[i] = full_[static_cast<std::size_t>(i)];
  for (std::size_t cell : body_.surface_cells()) {
    for (int i = 0; i < cell_nodes<dim>; ++i)
      flow[grid.cell_nodes_of(cell)[i]] += blocks_[cell].fill * geometry_[cell].extent[i];
    // Beyond slivers: water runs along them as along a half-filled cell, not with the acceleration of a thin film.
    for (std::size_t cell : body_.surface_cells())
      for (int i = 0; i < cell_nodes<dim>; ++i) {
        const auto node = static_cast<std::size_t>(grid.cell_nodes_of(cell)[i]);
        flow[node] = std::max(flow[node], 0.5 * all_[node]);
      }
  }
}

template <int dim>
double MovingLiquid<dim>::fill_of(std::size_t cell) const {
  for (std::size_t soil = 0; soil < laws_.size(); ++soil) {
    const std::size_t at = place(cell, static_cast<int>(soil));
    if (plan_.fields.points.count_of_cell()[at] > 0) return blocks_[at].fill;
  }
  return 1;
}

/// Velocity of the liquid at the start of the step, F_i of the liquid, and the liquid's pull on the skeleton:
///   F_i = sum_c f_ci (p_c + rho g.(x_i - x_c)),   pull_i = sum_c S_c p_c g_ci + m_l g.
template <int dim>
void MovingLiquid<dim>::add_force() {
  const auto velocity = axes<dim>(*w_.velocity), force = axes<dim>(*w_.force);
  const auto solid = axes<dim>(w_.moving->velocity_column()), pull = axes<dim>(w_.moving->force());
  for (int index : body_.nodes()) {
    const auto i = static_cast<std::size_t>(index);
    const LiquidNode<dim>& node = nodes_[i];
    Vector<dim> v{};
    const double per_water = node.water > 0 ? 1 / node.water : 0;
    for (int a = 0; a < dim; ++a) v[a] = node.momentum[a] * per_water - solid[a][i];
    w_.walls.project(i, v);
    for (int a = 0; a < dim; ++a) {
      velocity[a][i] = v[a] + solid[a][i];
      force[a][i] = 0;
      pull[a][i] += weight_[a] * node.water;
    }
  }
  for (const Hanging& h : hanging_)
    for (int a = 0; a < dim; ++a) force[a][h.node] += h.force[a];
  // At p = 0 on the surface itself, not on the nodes beyond it.
  for (const Rained& r : rained_) {
    const double beyond = r.height * (1 - fill_of(r.cell));
    const double hanging = beyond * dot<dim>(weight_, r.area) / length<dim>(r.area);
    for (int a = 0; a < dim; ++a) force[a][r.node] -= r.area[a] * hanging;
  }
  for (const Block& block : plan_.fields.points.blocks()) {
    const LiquidBlock<dim>& sums = blocks_[place(block)];
    const auto& faces = geometry_[block.cell].faces;
    const double head = sums.part * (sums.pressure - dot<dim>(weight_, sums.centre));
    const double pore = sums.saturation * sums.pressure;
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a) {
        force[a][block.nodes[i]] += head * faces[i][a];
        pull[a][block.nodes[i]] += pore * sums.push[i][a];
      }
  }
}

/// Eqs 10 and 11 with the drag, both phases at once.
template <int dim>
void MovingLiquid<dim>::solve(double dt) {
  w_.moving->solve(w_, body_.nodes(), dt);
}

template <int dim>
void MovingLiquid<dim>::follow_walls(double dt) {
  for (int index : body_.nodes()) {
    const auto i = static_cast<std::size_t>(index);
    if (!w_.walls.any(i)) continue;
    const Vector<dim> solid = w_.moving->get_new(i, dt);
    Vector<dim> v = mpm::at<dim>(*w_.velocity_new, i);
    for (int a = 0; a < dim; ++a) v[a] -= solid[a];
    w_.walls.project(i, v);
    for (int a = 0; a < dim; ++a) v[a] += solid[a];
    put<dim>(*w_.velocity_new, i, v);
  }
}

/// Eq. 13 (FLIP) and 14.
template <int dim>
void MovingLiquid<dim>::points(double) {
  const auto before = axes<dim>(*w_.velocity), after = axes<dim>(*w_.velocity_new);
  for (int i : body_.nodes()) back_[static_cast<std::size_t>(i)] = {};
  LinearShape<dim> shape(plan_.fields.grid);
  typename LinearShape<dim>::Stencil at;
  for (const Block& block : plan_.fields.points.blocks()) {
    std::array<Vector<dim>, cell_nodes<dim>> change;
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a) change[i][a] = after[a][block.nodes[i]] - before[a][block.nodes[i]];
    std::array<NodeSums<dim>, dim> momentum;
    const std::size_t end = block.first + block.count;
    shape.enter(block);
    for (std::size_t q = block.first; q < end; q += lane_count) {
      const LaneMask live = live_lanes(end - q);
      std::array<Lanes, dim> x;
      for (int a = 0; a < dim; ++a) x[a] = load((*points_.position)[a] + q);
      shape.values(x, at);
      const Lanes w = load((*points_.water)[0] + q);
      for (int a = 0; a < dim; ++a) {
        double* place = (*points_.velocity)[a] + q;
        Lanes v = load(place);
        for (int i = 0; i < cell_nodes<dim>; ++i) v += at.value[i] * change[i][a];
        store_live(v, place, live);
        momentum[a].add(w * v, at.value);
      }
    }
    double sums[dim][cell_nodes<dim>];
    for (int a = 0; a < dim; ++a) momentum[a].copy_to(sums[a]);
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a) back_[static_cast<std::size_t>(block.nodes[i])][a] += sums[a][i];
  }
  const auto velocity = axes<dim>(*w_.velocity), solid = axes<dim>(w_.moving->velocity_column());
  for (int index : body_.nodes()) {
    const auto i = static_cast<std::size_t>(index);
    const double per_water = nodes_[i].water > 0 ? 1 / nodes_[i].water : 0;
    Vector<dim> v{};
    for (int a = 0; a < dim; ++a) v[a] = back_[i][a] * per_water - solid[a][i];
    w_.walls.project(i, v);
    for (int a = 0; a < dim; ++a) velocity[a][i] = v[a] + solid[a][i];
  }
}

/// Step IV: w_i = (nS)_i (v_l - v_s)_i; from here on the column "liquid velocity" holds v_l - v_s.
template <int dim>
void MovingLiquid<dim>::relative_velocity() {
  const auto velocity = axes<dim>(*w_.velocity), flux = axes<dim>(*w_.flux), closing = axes<dim>(*w_.solid_velocity);
  const auto solid = axes<dim>(w_.moving->velocity_column());
  const double* content = (*w_.content)[0];
  for (int i : body_.nodes())
    for (int a = 0; a < dim; ++a) {
      velocity[a][i] -= solid[a][i];
      closing[a][i] = solid[a][i];
      flux[a][i] = content[i] * velocity[a][i];
    }
}

template <int dim>
double MovingLiquid<dim>::outflow(std::size_t cell, const std::array<double*, dim>& flux) const {
  const auto& faces = geometry_[cell].faces;
  const int* nodes = plan_.fields.grid.cell_nodes_of(cell);
  double out = 0;
  for (int i = 0; i < cell_nodes<dim>; ++i)
    for (int a = 0; a < dim; ++a) out += faces[i][a] * flux[a][nodes[i]];
  return out;
}

/// Step VI: W_p -= dt (V_p/V_c) sum_i f_ci . w_i, over all cells of a group together.
template <int dim>
void MovingLiquid<dim>::balance(double dt, bool as_printed) {
  const auto flux = axes<dim>(as_printed ? *w_.velocity : *w_.flux);
  double* water = (*points_.water)[0];
  const double* volume = (*points_.volume)[0];
  const auto leaves = [&](std::size_t at) {
    const LiquidBlock<dim>& sums = blocks_[at];
    return sums.part * outflow(cell_of(at), flux) * (as_printed ? sums.water / sums.volume : 1.0);
  };
  for (const Block& block : plan_.fields.points.blocks()) {
    const LiquidBlock<dim>& sums = blocks_[place(block)];
    double out = 0, all = sums.volume;
    if (sums.group < 0) {
      out = leaves(place(block));
    } else {
      const LiquidGroup& group = groups_[static_cast<std::size_t>(sums.group)];
      for (std::size_t at : group.blocks) out += leaves(at);
      all = group.volume;
    }
    const double change = -dt * out / all;
    for (std::size_t q = block.first; q < block.first + block.count; ++q) water[q] += change * volume[q];
  }
}

template <int dim>
double MovingLiquid<dim>::limit(int soil, double steps_ahead, double growth, double last_step) {
  const LiquidLaws& laws = laws_[static_cast<std::size_t>(soil)];
  const Soil& spec = plan_.problem.soils[static_cast<std::size_t>(soil)];
  const double modulus = LinearElastic(*spec.elastic).constrained_modulus();
  const bool is_explicit = plan_.stage.liquid == LiquidScheme::explicit_drag;
  const auto flux = axes<dim>(*w_.flux), closing = axes<dim>(*w_.solid_velocity);
  const double *content = (*w_.content)[0], *mobility = (*w_.mobility)[0], *rain = (*w_.rain_rate)[0],
               *volume = (*w_.volume)[0];
  for (int i : body_.nodes()) drag_[static_cast<std::size_t>(i)] = content[i] / (mobility[i] * w_.density);
  // What mapping to points and back leaves of the stiffest mode at least (README.md section 6b).
  constexpr double mapped = 0.5;
  double worst = 0;  // 1/dt
  for (const Block& block : plan_.fields.points.blocks(soil)) {
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
    const double ahead = e + steps_ahead * rate * growth * last_step;
    // Within a thousandth of the curve's scale of p = 0 a strain of 1e-6 saturates the cell.
    if (sums.pressure > -1e-3 * laws.pressure_scale || ahead >= laws.content.saturated())
      slope = std::min(slope, saturated);
    else
      slope = std::min(slope, laws.content.slope(laws.content.pressure_near(ahead)));
    CoupledCell cell;
    const double n = sums.pores / sums.volume, wet = sums.water / sums.volume, per_storage = 1 / (n * slope);
    const double all = sums.group < 0 ? sums.volume : groups_[static_cast<std::size_t>(sums.group)].volume;
    const double fill = body_.is_near_surface(block.cell) ? std::min(1.0, all / geometry.volume) : 1;
    const double s = sums.saturation, k = mapped * geometry.stiffness / fill;
    cell.liquid = wet * w_.density;
    cell.mixture = (1 - n) * laws.grain_density + cell.liquid;
    cell.k11 = mapped * geometry.stiffness * dim * modulus + k * s * s * per_storage;
    cell.k12 = k * s * wet * per_storage;
    cell.k22 = k * wet * wet * per_storage;
    cell.drag = is_explicit ? -most : std::isfinite(least) ? least : 0;
    if (!cell.stable(worst)) worst = std::max(worst, cell.critical());
  }
  return worst > 0 ? 1 / worst : std::numeric_limits<double>::infinity();
}

template class MovingLiquid<2>;
template class MovingLiquid<3>;

}  // namespace wetfront::mpm
