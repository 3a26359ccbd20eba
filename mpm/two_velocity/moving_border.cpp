#include "mpm/two_velocity/moving_liquid.h"

/// What of a moving body's liquid depends on which cells hold points: found anew for those that have come or gone.
namespace wetfront::mpm {

template <int dim>
void MovingLiquid<dim>::find_cells_at_nodes() {
  const Grid<dim>& grid = plan_.fields.grid;
  const auto at = [&grid](std::size_t cell, int i) { return static_cast<std::size_t>(grid.cell_nodes_of(cell)[i]); };
  for (std::size_t cell = 0; cell < geometry_.size(); ++cell)
    for (int i = 0; i < cell_nodes<dim>; ++i) ++cells_at_[at(cell, i) + 1];
  for (std::size_t node = 1; node < cells_at_.size(); ++node) cells_at_[node] += cells_at_[node - 1];
  around_.resize(cells_at_.back());
  std::vector<std::size_t> next(cells_at_);
  for (std::size_t cell = 0; cell < geometry_.size(); ++cell)
    for (int i = 0; i < cell_nodes<dim>; ++i) around_[next[at(cell, i)]++] = cell;
}

/// Integrals of N_i over the cells of the body around a node.
template <int dim>
void MovingLiquid<dim>::find_extents(std::size_t node) {
  full_[node] = all_[node] = 0;
  for (std::size_t k = cells_at_[node]; k < cells_at_[node + 1]; ++k) {
    const std::size_t cell = around_[k];
    if (!body_.occupied(static_cast<int>(cell))) continue;
    const int* nodes = plan_.fields.grid.cell_nodes_of(cell);
    int i = 0;
    while (static_cast<std::size_t>(nodes[i]) != node) ++i;
    all_[node] += geometry_[cell].extent[i];
    if (!body_.at_surface(cell)) full_[node] += geometry_[cell].extent[i];
  }
}

template <int dim>
void MovingLiquid<dim>::begin_body() {
  for (std::size_t node = 0; node < all_.size(); ++node) find_extents(node);
  find_border();
}

/// Walls, what hangs on outer faces and which of them are rained upon.
template <int dim>
void MovingLiquid<dim>::find_border() {
  const Grid<dim>& grid = plan_.fields.grid;
  w_.walls.find(grid, body_);
  held_nodes_.clear();
  for (int i : body_.nodes())
    if (const auto node = static_cast<std::size_t>(i); w_.walls.any(node) || w_.moving->fixed(node))
      held_nodes_.push_back(node);
  hanging_.clear();
  rained_.clear();
  for (const auto& outer : body_.outer()) {
    const auto local = local_face<dim>(outer.face);
    const auto integrals = Faces<dim>::integrals(grid, outer.cell, outer.face);
    Vector<dim> whole{};
    for (const auto& part : integrals)
      for (int a = 0; a < dim; ++a) whole[a] += part[a];
    const double size = length<dim>(whole);
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

template void MovingLiquid<2>::begin_body();
template void MovingLiquid<2>::find_border();
template void MovingLiquid<2>::find_cells_at_nodes();
template void MovingLiquid<2>::find_extents(std::size_t);
template void MovingLiquid<3>::begin_body();
template void MovingLiquid<3>::find_border();
template void MovingLiquid<3>::find_cells_at_nodes();
template void MovingLiquid<3>::find_extents(std::size_t);

}  // namespace wetfront::mpm
