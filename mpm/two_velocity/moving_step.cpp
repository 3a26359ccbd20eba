#include "mpm/grid/column_vector.h"
#include "mpm/skeleton/skeleton_columns.h"
#include "mpm/two_velocity/over_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

/// A step of the two-velocity liquid in a moving body (README.md section 3b: phase -> equation).
namespace wetfront::mpm {

/// Velocity of the liquid at the start of the step, F_i of the liquid, and the liquid's pull on the skeleton:
///   F_i = sum_c f_ci (p_c + rho g.(x_i - x_c)),   pull_i = sum_c S_c p_c g_ci + m_l g.
template <int dim>
void MovingLiquid<dim>::add_force() {
  const auto velocity = axes<dim>(*w_.velocity), force = axes<dim>(*w_.force);
  const auto solid = axes<dim>(w_.moving->velocity_column()), pull = axes<dim>(w_.moving->force());
  over_nodes([&](std::size_t i) {
    const LiquidNode<dim>& node = nodes_[i];
    Vector<dim> v{};
    const double per_water = node.water > 0 ? 1 / node.water : 0;
    for (int a = 0; a < dim; ++a) v[a] = node.momentum[a] * per_water;
    w_.walls.project(i, v);
    for (int a = 0; a < dim; ++a) {
      solid_at_[i][a] = solid[a][i];
      velocity[a][i] = v[a] + solid[a][i];
      force[a][i] = 0;
      pull[a][i] += weight_[a] * node.water;
    }
  });
  for (const Hanging& h : hanging_)
    for (int a = 0; a < dim; ++a) force[a][h.node] += h.force[a];
  // At p = 0 on the surface itself, not on the nodes beyond it.
  for (const Rained& r : rained_) {
    const double beyond = r.height * (1 - fill_of(r.cell));
    const double hanging = beyond * dot<dim>(weight_, r.area) / length<dim>(r.area);
    for (int a = 0; a < dim; ++a) force[a][r.node] -= r.area[a] * hanging;
  }
  over_cells([&](std::span<const Block> blocks, Found&) {
    for (const Block& block : blocks) {
      const LiquidBlock<dim>& sums = blocks_[place(block)];
      const auto& faces = faces_[block.cell];
      const CellNodes<dim> nodes(block.nodes);
      const double head = sums.part * (sums.pressure - dot<dim>(weight_, sums.centre));
      const double pore = sums.saturation * sums.pressure;
      for (int a = 0; a < dim; ++a) {
        nodes.add(times(head, faces[a]), force[a]);
        nodes.add(times(pore, sums.push[a]), pull[a]);
      }
    }
  });
}

/// Eqs 10 and 11 with the drag, both phases at once.
template <int dim>
void MovingLiquid<dim>::solve(double dt) {
  over_node_runs([&](const NodeRun& run) { w_.moving->solve(w_, run, dt); });
  for (std::size_t i : held_nodes_) w_.moving->solve_held(w_, i, dt);
  for (const auto& body : after_solve_) body();
  over_nodes([&](std::size_t i) { decided_[i] = w_.moving->get_new(solid_at_[i], i, dt); });
}

/// Of the body's nodes [1/s].
template <int dim>
double MovingLiquid<dim>::least_drag() const {
  const double *content = (*w_.content)[0], *mobility = (*w_.mobility)[0];
  Lanes least(std::numeric_limits<double>::infinity());
  for (const NodeRun& run : body_.node_runs())
    in_lanes(
        run.first, run.last, [&]<class Number>(std::size_t i) __attribute__((always_inline)) {
          least = min(least, Lanes(load<Number>(content + i) / load<Number>(mobility + i)));
        });
  return std::experimental::hmin(least) / w_.density;
}

/// What contact and sides have made of the skeleton is what drags: a base that holds it holds the liquid too, which
/// would else run on by g dt, several K_s.
template <int dim>
void MovingLiquid<dim>::follow_skeleton(double dt) {
  for (int index : body_.nodes()) {
    const auto i = static_cast<std::size_t>(index);
    const Vector<dim> solid = w_.moving->get_new(solid_at_[i], i, dt);
    if (solid == decided_[i]) continue;
    Vector<dim> v = w_.moving->liquid_against(w_, i, solid, dt);
    for (int a = 0; a < dim; ++a) v[a] -= solid[a];
    w_.walls.project(i, v);
    for (int a = 0; a < dim; ++a) v[a] += solid[a];
    put<dim>(*w_.velocity_new, i, v);
  }
}

/// Eq. 13 (FLIP) and 14, of the velocity against the skeleton:
///
///   v_l += sum N (v_l' - v_l)_i - e (u_p - sum N u_i),   u = v_l - v_s,   e <= 1/50.
///
/// FLIP never sees what points of a cell do against each other, so no drag ever slowed it, and it came back as flux
/// when points crossed: e is a share of PIC, no more of it than the least drag would take in the step. u_i is the mean
/// of u_p by water, so that momentum is kept whatever e is. What a node gives is one gift: u' = (1 - e) u + sum N gift.
template <int dim>
void MovingLiquid<dim>::points(double dt) {
  const auto before = axes<dim>(*w_.velocity), after = axes<dim>(*w_.velocity_new);
  constexpr double most_share = 0.02;
  const double least = least_drag();
  const double share = most_share * dt * least / (1 + dt * least);
  over_nodes([&](std::size_t i) {
    for (auto& axis : back_) axis[i] = 0;
    const Vector<dim> solid_new = w_.moving->get_new(solid_at_[i], i, dt);
    const double per_water = nodes_[i].water > 0 ? 1 / nodes_[i].water : 0;
    for (int a = 0; a < dim; ++a) {
      const double against = before[a][i] - solid_at_[i][a], change = after[a][i] - before[a][i];
      const double towards = after[a][i] - solid_new[a] + (nodes_[i].momentum[a] * per_water - against);
      gifts_[i][a] = (1 - share) * change + share * towards;
    }
  });
  over_cells([&](std::span<const Block> blocks, Found&) {
    LinearShape<dim> shape(plan_.fields.grid);
    for (const Block& block : blocks) points_of(block, shape, share);
  });
  const auto velocity = axes<dim>(*w_.velocity), solid = axes<dim>(w_.moving->velocity_column());
  over_nodes([&](std::size_t i) {
    const double per_water = nodes_[i].water > 0 ? 1 / nodes_[i].water : 0;
    Vector<dim> v{};
    for (int a = 0; a < dim; ++a) v[a] = back_[static_cast<std::size_t>(a)][i] * per_water;
    w_.walls.project(i, v);
    for (int a = 0; a < dim; ++a) velocity[a][i] = v[a] + solid[a][i];
  });
}

/// Of one cell.
template <int dim>
void MovingLiquid<dim>::points_of(const Block& block, LinearShape<dim>& shape, double share) {
  shape.enter(block);
  using Field = typename LinearShape<dim>::Field;
  std::array<Field, dim> gift;
  for (std::size_t a = 0; a < dim; ++a)
    gift[a] = shape.field([&](int i) { return gifts_[static_cast<std::size_t>(block.nodes[i])][a]; });
  std::array<NodeSums<dim>, dim> momentum;
  typename LinearShape<dim>::Stencil at;
  const std::size_t end = block.first + block.count;
  for (std::size_t q = block.first; q < end; q += lane_count) {
    const LaneMask live = live_lanes(end - q);
    std::array<Lanes, dim> x;
    for (int a = 0; a < dim; ++a) x[a] = load((*points_.position)[a] + q);
    shape.values(x, at);
    const Lanes w = load((*points_.water)[0] + q);
    for (int a = 0; a < dim; ++a) {
      double* place = (*points_.velocity)[a] + q;
      const Lanes solid = load((*points_.solid_velocity)[a] + q);
      const Lanes u = (1 - share) * (load(place) - solid) + shape.value(gift[a], at);
      store_live(u + solid, place, live);
      momentum[a].add(w * u, at.value);
    }
  }
  const CellNodes<dim> nodes(block.nodes);
  for (std::size_t a = 0; a < dim; ++a) nodes.add(momentum[a].part, back_[a].data());
}

/// Step IV: w_i = (nS)_i (v_l - v_s)_i; from here on the column "liquid velocity" holds v_l - v_s.
template <int dim>
void MovingLiquid<dim>::relative_velocity() {
  const auto velocity = axes<dim>(*w_.velocity), flux = axes<dim>(*w_.flux), closing = axes<dim>(*w_.solid_velocity);
  const auto solid = axes<dim>(w_.moving->velocity_column());
  const double* content = (*w_.content)[0];
  over_nodes([&](std::size_t i) {
    for (int a = 0; a < dim; ++a) {
      velocity[a][i] -= solid[a][i];
      closing[a][i] = solid[a][i];
      flux[a][i] = content[i] * velocity[a][i];
    }
  });
}

template <int dim>
double MovingLiquid<dim>::outflow(const Block& block, const std::array<double*, dim>& flux) const {
  const CellNodes<dim> nodes(block.nodes);
  Lanes out(0.0);
  for (int a = 0; a < dim; ++a) out += product(faces_[block.cell][a], nodes.of(flux[a]));
  return mpm::sum(out);
}

template void MovingLiquid<2>::add_force();
template void MovingLiquid<2>::solve(double);
template double MovingLiquid<2>::least_drag() const;
template void MovingLiquid<2>::follow_skeleton(double);
template void MovingLiquid<2>::points(double);
template void MovingLiquid<2>::relative_velocity();
template double MovingLiquid<2>::outflow(const Block&, const std::array<double*, 2>&) const;
template void MovingLiquid<3>::add_force();
template void MovingLiquid<3>::solve(double);
template void MovingLiquid<3>::follow_skeleton(double);
template void MovingLiquid<3>::points(double);
template void MovingLiquid<3>::relative_velocity();
template double MovingLiquid<3>::outflow(const Block&, const std::array<double*, 3>&) const;

}  // namespace wetfront::mpm
