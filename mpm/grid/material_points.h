#pragma once

#include "mpm/grid/grid.h"
#include "mpm/plan/column.h"

#include <span>
#include <vector>

namespace wetfront::mpm {

/// Points that share a cell: points first .. first+count-1 of every column.
struct Block {
  std::size_t cell = 0;
  const int* nodes = nullptr;  ///< the cell's nodes
  std::size_t first = 0, count = 0;
};

/// The material points, sorted by cell, as columns. "position" [m] and "volume" [m^dim] are always there; every other
/// column is provided by an effect.
template <int dim>
class MaterialPoints {
 public:
  /// Sorted positions and volumes; `count_of_cell[c]` points lie in cell c.
  MaterialPoints(const Grid<dim>& grid, const std::vector<Vector<dim>>& positions, const std::vector<double>& volumes,
                 const std::vector<std::size_t>& count_of_cell);

  std::size_t size() const { return columns.size(); }
  /// Occupied cells of one soil region, or of all.
  std::span<const Block> blocks(int region) const;
  std::span<const Block> blocks() const { return blocks_; }
  bool occupied(std::size_t cell) const { return count_of_cell_[cell] > 0; }
  const std::vector<std::size_t>& count_of_cell() const { return count_of_cell_; }
  Vector<dim> position(std::size_t point) const;

  /// New numbers of points per cell after points moved (or were restored); makes the blocks again.
  void set_counts(const Grid<dim>& grid, std::span<const std::size_t> count_of_cell);

  ColumnSet columns;

 private:
  std::vector<std::size_t> count_of_cell_;
  std::vector<Block> blocks_;              ///< by region, then by cell
  std::vector<std::size_t> region_start_;  ///< into blocks_
  std::vector<std::vector<std::size_t>> cells_of_region_;
  const double* position_ = nullptr;
};

}  // namespace wetfront::mpm
