#include "mpm/grid/material_points.h"

#include <algorithm>
#include <numeric>

namespace wetfront::mpm {

template <int dim>
MaterialPoints<dim>::MaterialPoints(const Grid<dim>& grid, const std::vector<Vector<dim>>& positions,
                                    const std::vector<double>& volumes, const std::vector<std::size_t>& count_of_cell)
    : columns(positions.size()), count_of_cell_(count_of_cell) {
  Column& position = columns.provide({"position", "x", "m", dim}, "material points");
  Column& volume = columns.provide({"volume", "V", dim == 2 ? "m2" : "m3"}, "material points");
  columns.allocate();
  for (std::size_t p = 0; p < positions.size(); ++p) {
    for (int a = 0; a < dim; ++a) position[a][p] = positions[p][a];
    volume[0][p] = volumes[p];
  }
  int regions = 0;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) regions = std::max(regions, grid.region(cell) + 1);
  cells_of_region_.resize(static_cast<std::size_t>(regions));
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell)
    cells_of_region_[static_cast<std::size_t>(grid.region(cell))].push_back(cell);
  blocks_.reserve(grid.cell_count());
  region_start_.reserve(static_cast<std::size_t>(regions) + 1);
  set_counts(grid, count_of_cell_);
  position_ = position[0];
}

template <int dim>
void MaterialPoints<dim>::set_counts(const Grid<dim>& grid, std::span<const std::size_t> count_of_cell) {
  if (count_of_cell.data() != count_of_cell_.data())
    std::copy(count_of_cell.begin(), count_of_cell.end(), count_of_cell_.begin());
  blocks_.clear();
  region_start_.assign(1, 0);
  // Points are stored region by region, and within a region cell by cell: a block loop walks memory forwards.
  std::size_t first = 0;
  for (const auto& cells : cells_of_region_) {
    for (std::size_t cell : cells) {
      const std::size_t count = count_of_cell_[cell];
      if (count > 0) blocks_.push_back({cell, grid.cell_nodes_of(cell), first, count});
      first += count;
    }
    region_start_.push_back(blocks_.size());
  }
}

template <int dim>
std::span<const Block> MaterialPoints<dim>::blocks(int region) const {
  const auto r = static_cast<std::size_t>(region);
  if (r + 1 >= region_start_.size()) return {};
  return std::span<const Block>(blocks_).subspan(region_start_[r], region_start_[r + 1] - region_start_[r]);
}

template <int dim>
Vector<dim> MaterialPoints<dim>::position(std::size_t point) const {
  Vector<dim> x{};
  for (int a = 0; a < dim; ++a) x[a] = position_[static_cast<std::size_t>(a) * size() + point];
  return x;
}

template class MaterialPoints<2>;
template class MaterialPoints<3>;

}  // namespace wetfront::mpm
