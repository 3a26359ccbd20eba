#include "mpm/grid/column_vector.h"
#include "mpm/two_velocity/over_cells.h"

#include <algorithm>

/// Pressures of cells near the surface, and what all of them bring to the nodes.
namespace wetfront::mpm {

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
  const double p = laws.content.pressure_of(content);
  if (explains(p)) return p;
  throw StepFailed("the two-velocity scheme has blown up: cell " + std::to_string(cell) + " at " +
                   place_text<dim>(centre) + " holds " + std::to_string(content) +
                   " of its pores, which no pressure explains" + step_against_limit<dim>(plan_, w_));
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
      if (group_count_ == groups_.size()) groups_.emplace_back().blocks.reserve(1 + cell_faces<dim>);
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
  for (std::size_t cell : narrowed_) faces_[cell] = whole_faces_[cell];
  narrowed_.assign(body_.surface_cells().begin(), body_.surface_cells().end());
  for (std::size_t cell : narrowed_) faces_[cell] = faces_of(cell, false);
}

template <int dim>
NodalVectors<dim> MovingLiquid<dim>::faces_of(std::size_t cell, bool whole) const {
  NodalVectors<dim> faces{};
  for (int f = 0; f < cell_faces<dim>; ++f) {
    const int across = body_.faces().neighbour(cell, f);
    double part = 1;
    if (!whole && body_.occupied(across) && body_.at_surface(static_cast<std::size_t>(across)))
      part = 0.5 * (fill_of(cell) + fill_of(static_cast<std::size_t>(across)));
    const auto local = local_face<dim>(f);
    const auto integrals = Faces<dim>::integrals(plan_.fields.grid, cell, f);
    for (std::size_t k = 0; k < local.size(); ++k)
      for (int a = 0; a < dim; ++a) faces[a][static_cast<std::size_t>(local[k])] += part * integrals[k][a];
  }
  return faces;
}

/// Pressures of the cells near the surface, one potential p - rho g.x in each group, and what they bring to the nodes.
template <int dim>
void MovingLiquid<dim>::share_pressures() {
  const Grid<dim>& grid = plan_.fields.grid;
  for (std::size_t g = 0; g < group_count_; ++g) {
    LiquidGroup& group = groups_[g];
    Vector<dim> centre{};
    group.volume = group.pores = group.water = 0;
    for (std::size_t at : group.blocks) {
      const LiquidBlock<dim>& sums = blocks_[at];
      group.pores += sums.pores;
      group.water += sums.water;
      group.volume += sums.volume;
      for (int a = 0; a < dim; ++a) centre[a] += sums.volume * sums.centre[a];
    }
    for (double& component : centre) component /= group.volume;
    const LiquidLaws& laws = laws_of(group.blocks[0]);
    const double content = group.water / group.pores, p = pressure_at(laws, content, centre, cell_of(group.blocks[0]));
    const double potential = p - dot<dim>(weight_, centre);
    stored_ += group.pores * laws.content.value(p);
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
      stored_ += sums.pores * take_pressure(at, pressure_at(laws, content, sums.centre, cell), content, laws);
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
  over_nodes([&](std::size_t i) {
    const LiquidNode<dim>& node = nodes_[i];
    const double per_volume = 1 / node.volume;
    volume[i] = node.volume;
    content[i] = node.water * per_volume;
    double p = node.pressure * per_volume;
    for (int a = 0; a < dim; ++a) {
      offset[a][i] = plan_.fields.grid.node(static_cast<int>(i))[a] - node.centre[a] * per_volume;
      p += weight_[a] * offset[a][i];
    }
    pressure[i] = p;
    of_cells[i] = node.mobility * per_volume;
    mobility[i] = (one_soil ? of_cells[i] + 2 * laws_[0].mobility(p) : of_cells[i]) / 3;
  });
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
    const double fill = fill_of(cell);
    for (int i = 0; i < cell_nodes<dim>; ++i) flow[grid.cell_nodes_of(cell)[i]] += fill * geometry_[cell].extent[i];
  }
  // Beyond slivers: water runs along them as along a half-filled cell, not with the acceleration of a thin film.
  for (std::size_t cell : body_.surface_cells())
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      const auto node = static_cast<std::size_t>(grid.cell_nodes_of(cell)[i]);
      flow[node] = std::max(flow[node], 0.5 * all_[node]);
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

template void MovingLiquid<2>::find_parts();
template double MovingLiquid<2>::pressure_at(const LiquidLaws&, double, const Vector<2>&, std::size_t) const;
template void MovingLiquid<2>::group_slivers();
template void MovingLiquid<2>::open_faces();
template NodalVectors<2> MovingLiquid<2>::faces_of(std::size_t, bool) const;
template void MovingLiquid<2>::share_pressures();
template void MovingLiquid<2>::finish_nodes();
template double MovingLiquid<2>::fill_of(std::size_t) const;
template void MovingLiquid<3>::find_parts();
template double MovingLiquid<3>::pressure_at(const LiquidLaws&, double, const Vector<3>&, std::size_t) const;
template void MovingLiquid<3>::group_slivers();
template void MovingLiquid<3>::open_faces();
template NodalVectors<3> MovingLiquid<3>::faces_of(std::size_t, bool) const;
template void MovingLiquid<3>::share_pressures();
template void MovingLiquid<3>::finish_nodes();
template double MovingLiquid<3>::fill_of(std::size_t) const;

}  // namespace wetfront::mpm
