#include "mpm/grid/column_vector.h"
#include "mpm/skeleton/skeleton_columns.h"
#include "mpm/two_velocity/moving_liquid.h"

/// A step of the two-velocity liquid in a moving body (README.md section 3b: phase -> equation).
namespace wetfront::mpm {

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
void MovingLiquid<dim>::points() {
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

template void MovingLiquid<2>::add_force();
template void MovingLiquid<2>::solve(double);
template void MovingLiquid<2>::follow_walls(double);
template void MovingLiquid<2>::points();
template void MovingLiquid<2>::relative_velocity();
template void MovingLiquid<2>::balance(double, bool);
template void MovingLiquid<3>::add_force();
template void MovingLiquid<3>::solve(double);
template void MovingLiquid<3>::follow_walls(double);
template void MovingLiquid<3>::points();
template void MovingLiquid<3>::relative_velocity();
template void MovingLiquid<3>::balance(double, bool);

}  // namespace wetfront::mpm
