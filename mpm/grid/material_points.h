#pragma once

#include "mpm/grid/grid.h"
#include "mpm/grid/slot_rooms.h"
#include "mpm/plan/column.h"

#include <cstdint>
#include <span>
#include <vector>

namespace wetfront::mpm {

/// Points of one soil that share a cell: slots first .. first+count-1 of every column. Where points may move, `first`
/// is a multiple of lane_count and the slots up to the next multiple are there: dead beyond `count`, all carried
/// columns zero but the position, which is some place near the cell. Full lanes may run over them and add nothing.
struct Block {
  std::size_t cell = 0;
  const int* nodes = nullptr;  ///< the cell's nodes
  std::size_t first = 0, count = 0;
  int soil = 0;  ///< its points belong to it, wherever they are
};

/// A point that leaves its cell for another: `index` is its place in the block.
struct Mover {
  std::size_t from = 0, to = 0, index = 0;
  int soil = 0;
};

/// The material points, sorted by soil and cell, as columns. "position" [m] and "volume" [m^dim] are always there;
/// every other column is provided by an effect. What is computed depends on the order of the points in their cells
/// (which is state) and never on the slots they have (which is not).
template <int dim>
class MaterialPoints {
 public:
  /// Sorted positions and volumes; `count_of_cell[c]` points lie in cell c, of the soil of its region.
  MaterialPoints(const Grid<dim>& grid, const std::vector<Vector<dim>>& positions, const std::vector<double>& volumes,
                 const std::vector<std::size_t>& count_of_cell);

  /// Number of points. Columns are as long as there are slots: at least as many.
  std::size_t size() const { return size_; }
  std::size_t slots() const { return columns.size(); }
  /// Occupied cells of one soil, or of all; by soil, then by cell.
  std::span<const Block> blocks(int soil) const;
  std::span<const Block> blocks() const { return blocks_; }
  bool occupied(std::size_t cell) const;
  /// Per soil, then per cell.
  const std::vector<std::size_t>& count_of_cell() const { return count_of_cell_; }
  Vector<dim> position(std::size_t slot) const;
  std::size_t first_slot(std::size_t cell, int soil) const { return first_[key(cell, soil)]; }
  /// Sum of a column in the order of the points.
  double sum(const Column& column) const;
  /// Another number once a cell has become occupied or empty. Blocks keep their places in blocks() while it stays.
  long version() const { return version_; }

  /// Numbers of points per soil and cell of a state; makes blocks and slots anew, moves no data.
  void set_counts(const Grid<dim>& grid, std::span<const std::size_t> count_of_cell);
  /// Gives blocks whole lanes and room to grow, before any column but position and volume holds data.
  void make_room(const Grid<dim>& grid);
  /// Takes every mover from its cell to the end of the other. They are in the order of the blocks, and within a block
  /// in the order of the slots. `scratch` is a column of one component.
  void move(const Grid<dim>& grid, std::span<const Mover> movers, Column& scratch);

  /// Values of a carried column in the order of the points, component by component, and back.
  std::vector<double> in_order(const Column& column) const;
  void put_in_order(std::span<const double> values, Column& column) const;

  ColumnSet columns;

 private:
  std::size_t key(std::size_t cell, int soil) const { return static_cast<std::size_t>(soil) * cells_ + cell; }
  std::size_t slots_wanted() const;
  void lay_out(std::size_t slots);
  void lay_out_again(std::size_t key_to_grow, Column& scratch);
  void carry_over(std::size_t slots, Column& scratch);
  bool grow(std::size_t key);
  void append(std::size_t key, std::size_t slot);
  void remove(std::size_t key, std::size_t index);
  void copy_slot(std::size_t from, std::size_t to);
  void clear_slots(std::size_t first, std::size_t last, std::size_t like);
  void remake_blocks(const Grid<dim>& grid);

  std::size_t cells_ = 0, size_ = 0;
  bool roomy_ = false;
  long version_ = 0;
  std::vector<std::size_t> count_of_cell_;
  std::vector<Block> blocks_;            ///< by soil, then by cell
  std::vector<std::size_t> soil_start_;  ///< into blocks_
  std::vector<std::size_t> first_;       ///< slot, per soil and cell
  // Only where points may move:
  std::vector<std::uint32_t> room_;      ///< slots, per soil and cell
  std::vector<std::size_t> came_;        ///< soils and cells that have become occupied
  std::vector<std::size_t> first_then_;  ///< before the layout under way
  SlotRooms rooms_;
};

}  // namespace wetfront::mpm
