#include "mpm/grid/material_points.h"

#include "mpm/plan/long_zeros.h"

#include <algorithm>
#include <numeric>

namespace wetfront::mpm {

namespace {

/// Room kept free beside the points' own: an eighth at least, else a new layout takes a quarter.
std::size_t spare(std::size_t slots, std::size_t share) {
  return SlotRooms::rounded(slots / share + 64);
}

bool carried(const Column& column) {
  return column.spec().lifetime == Lifetime::carried && column.allocated();
}

/// Asks for two slots of all carried columns, which are about to be worked on.
void fetch(const ColumnSet& columns, std::size_t one, std::size_t other) {
  for (const auto& column : columns.all()) {
    if (!carried(*column)) continue;
    const double* values = (*column)[0];
    for (int c = 0; c < column->spec().components; ++c, values += column->size())
      __builtin_prefetch(values + one), __builtin_prefetch(values + other);
  }
}

}  // namespace

template <int dim>
MaterialPoints<dim>::MaterialPoints(const Grid<dim>& grid, const std::vector<Vector<dim>>& positions,
                                    const std::vector<double>& volumes, const std::vector<std::size_t>& count_of_cell)
    : columns(positions.size()), cells_(grid.cell_count()) {
  Column& position = columns.provide({"position", "x", "m", dim}, "material points");
  Column& volume = columns.provide({"volume", "V", dim == 2 ? "m2" : "m3"}, "material points");
  columns.allocate();
  for (std::size_t p = 0; p < positions.size(); ++p) {
    for (int a = 0; a < dim; ++a) position[a][p] = positions[p][a];
    volume[0][p] = volumes[p];
  }
  int soils = 0;
  for (std::size_t cell = 0; cell < cells_; ++cell) soils = std::max(soils, grid.region(cell) + 1);
  std::vector<std::size_t> counts(static_cast<std::size_t>(soils) * cells_);
  for (std::size_t cell = 0; cell < cells_; ++cell) counts[key(cell, grid.region(cell))] = count_of_cell[cell];
  soil_start_.resize(static_cast<std::size_t>(soils) + 1);
  blocks_.reserve(cells_);
  set_counts(grid, counts);
}

template <int dim>
void MaterialPoints<dim>::set_counts(const Grid<dim>& grid, std::span<const std::size_t> count_of_cell) {
  count_of_cell_.assign(count_of_cell.begin(), count_of_cell.end());
  size_ = std::accumulate(count_of_cell_.begin(), count_of_cell_.end(), std::size_t{0});
  if (roomy_) {
    const std::size_t wanted = slots_wanted(), slots = wanted + spare(wanted, 4);
    columns.resize(slots);
    lay_out(slots);
  } else {
    first_.resize(count_of_cell_.size());
    std::exclusive_scan(count_of_cell_.begin(), count_of_cell_.end(), first_.begin(), std::size_t{0});
  }
  came_.clear();
  blocks_.clear();
  for (std::size_t k = 0; k < count_of_cell_.size(); ++k)
    if (count_of_cell_[k] > 0) came_.push_back(k);
  remake_blocks(grid);
}

template <int dim>
void MaterialPoints<dim>::make_room(const Grid<dim>& grid) {
  if (roomy_) return;
  std::vector<std::vector<double>> values;
  for (const auto& column : columns.all()) values.push_back(in_order(*column));
  roomy_ = true;
  set_counts(grid, std::vector<std::size_t>(count_of_cell_));
  for (std::size_t k = 0; k < values.size(); ++k) put_in_order(values[k], *columns.all()[k]);
}

template <int dim>
std::size_t MaterialPoints<dim>::slots_wanted() const {
  std::size_t slots = 0;
  for (std::size_t count : count_of_cell_) slots += SlotRooms::rounded(count);
  return slots;
}

/// Rooms in the order of soils and cells, none longer than needed.
template <int dim>
void MaterialPoints<dim>::lay_out(std::size_t slots) {
  first_.resize(count_of_cell_.size());
  room_.resize(count_of_cell_.size());
  first_then_.reserve(count_of_cell_.size());
  rooms_.reset(slots);
  for (std::size_t k = 0; k < count_of_cell_.size(); ++k) {
    const std::size_t room = SlotRooms::rounded(count_of_cell_[k]);
    room_[k] = static_cast<std::uint32_t>(room);
    first_[k] = room > 0 ? rooms_.take(room) : 0;
  }
}

template <int dim>
void MaterialPoints<dim>::lay_out_again(std::size_t key_to_grow, Column& scratch) {
  const std::size_t wanted = slots_wanted() + SlotRooms::rounded(count_of_cell_[key_to_grow] + 1);
  const std::size_t slots = wanted + spare(wanted, 8) > this->slots() ? wanted + spare(wanted, 4) : this->slots();
  first_then_ = first_;
  lay_out(slots);
  carry_over(slots, scratch);
}

/// Carried columns from the slots they had to those they have now.
template <int dim>
void MaterialPoints<dim>::carry_over(std::size_t slots, Column& scratch) {
  const bool longer = slots != this->slots();
  for (const auto& column : columns.all()) {
    const int components = column->allocated() ? column->spec().components : 0;
    std::vector<double> fresh;
    if (longer) fresh = long_zeros(slots * static_cast<std::size_t>(components));
    for (int c = 0; carried(*column) && c < components; ++c) {
      double* to = longer ? fresh.data() + static_cast<std::size_t>(c) * slots : scratch[0];
      if (!longer) std::fill_n(to, slots, 0.0);
      for (std::size_t k = 0; k < first_.size(); ++k) {
        if (count_of_cell_[k] == 0) continue;
        const double* from = (*column)[c] + first_then_[k];
        for (std::size_t p = 0; p < SlotRooms::rounded(count_of_cell_[k]); p += SlotRooms::unit)
          for (std::size_t q = p; q < p + SlotRooms::unit; ++q) to[first_[k] + q] = from[q];
        if (column->spec().name == "position")
          std::fill(to + first_[k] + count_of_cell_[k], to + first_[k] + room_[k], to[first_[k]]);
      }
      if (!longer) std::copy_n(to, slots, (*column)[c]);
    }
    if (longer) column->replace(std::move(fresh), slots);
  }
  columns.set_size(slots);
}

/// A longer room for the points of a key; false when there is none left.
template <int dim>
bool MaterialPoints<dim>::grow(std::size_t k) {
  const std::size_t size = SlotRooms::rounded(count_of_cell_[k] + 1), first = rooms_.take(size);
  if (first == SlotRooms::none) return false;
  for (std::size_t p = 0; p < count_of_cell_[k]; ++p) copy_slot(first_[k] + p, first + p);
  if (room_[k] > 0) rooms_.give_back(first_[k], room_[k]);
  first_[k] = first;
  room_[k] = static_cast<std::uint32_t>(size);
  return true;
}

template <int dim>
void MaterialPoints<dim>::copy_slot(std::size_t from, std::size_t to) {
  for (const auto& column : columns.all()) {
    if (!carried(*column)) continue;
    double* values = (*column)[0];
    for (int c = 0; c < column->spec().components; ++c, values += column->size()) values[to] = values[from];
  }
}

/// Makes slots dead, at the place of the point in slot `like`.
template <int dim>
void MaterialPoints<dim>::clear_slots(std::size_t first, std::size_t last, std::size_t like) {
  for (const auto& column : columns.all()) {
    if (!carried(*column)) continue;
    const bool position = column == columns.all().front();
    double* values = (*column)[0];
    for (int c = 0; c < column->spec().components; ++c, values += column->size())
      for (std::size_t slot = first; slot < last; ++slot) values[slot] = position ? values[like] : 0.0;
  }
}

template <int dim>
void MaterialPoints<dim>::append(std::size_t k, std::size_t slot) {
  const std::size_t to = first_[k] + count_of_cell_[k];
  copy_slot(slot, to);
  if (to % SlotRooms::unit == 0) clear_slots(to + 1, to + SlotRooms::unit, to);
  if (count_of_cell_[k]++ == 0) came_.push_back(k);
}

/// The last point of the cell takes the place of the one that goes.
template <int dim>
void MaterialPoints<dim>::remove(std::size_t k, std::size_t index) {
  const std::size_t last = first_[k] + --count_of_cell_[k];
  if (first_[k] + index != last) copy_slot(last, first_[k] + index);
  clear_slots(last, last + 1, first_[k]);
  if (count_of_cell_[k] > 0) return;
  rooms_.give_back(first_[k], room_[k]);
  room_[k] = 0;
}

template <int dim>
void MaterialPoints<dim>::move(const Grid<dim>& grid, std::span<const Mover> movers, Column& scratch) {
  if (movers.empty()) return;
  constexpr std::size_t ahead = 6;
  // From the back: within a cell the last point is then never one that has still to go.
  for (std::size_t m = movers.size(); m-- > 0;) {
    if (m >= ahead) {
      const Mover& later = movers[m - ahead];
      const std::size_t goes_to = key(later.to, later.soil);
      fetch(columns, first_[key(later.from, later.soil)] + later.index, first_[goes_to] + count_of_cell_[goes_to]);
    }
    const Mover& mover = movers[m];
    const std::size_t from = key(mover.from, mover.soil), to = key(mover.to, mover.soil);
    if (count_of_cell_[to] == room_[to] && !grow(to)) {
      lay_out_again(to, scratch);
      grow(to);
    }
    append(to, first_[from] + mover.index);
    remove(from, mover.index);
  }
  // Rooms that have been changed for longer ones lie anywhere: a pass over the cells then waits for memory.
  constexpr std::size_t near_by = 32;
  std::size_t strayed = 0, next = 0, any = 0;
  for (const Block& block : blocks_) {
    const std::size_t k = key(block.cell, block.soil);
    if (count_of_cell_[k] == 0) continue;
    strayed += first_[k] < next || first_[k] > next + near_by ? 1 : 0;
    next = first_[k] + room_[k];
    any = k;
  }
  if (strayed > blocks_.size() / 3) lay_out_again(any, scratch);
  remake_blocks(grid);
}

/// Refreshes the blocks that stay, drops those without points, inserts those of `came_`.
template <int dim>
void MaterialPoints<dim>::remake_blocks(const Grid<dim>& grid) {
  const auto key_of = [this](const Block& block) { return key(block.cell, block.soil); };
  std::size_t kept = 0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const std::size_t k = key_of(blocks_[b]);
    if (count_of_cell_[k] == 0) continue;
    if (kept != b) blocks_[kept] = blocks_[b];
    blocks_[kept].first = first_[k];
    blocks_[kept++].count = count_of_cell_[k];
  }
  bool changed = kept != blocks_.size();
  blocks_.resize(kept);
  std::sort(came_.begin(), came_.end());
  came_.erase(std::unique(came_.begin(), came_.end()), came_.end());
  // A cell that was left and entered again within one step has kept its block.
  std::erase_if(came_, [&](std::size_t k) {
    const auto at = std::lower_bound(blocks_.begin(), blocks_.end(), k,
                                     [&](const Block& block, std::size_t other) { return key_of(block) < other; });
    return count_of_cell_[k] == 0 || (at != blocks_.end() && key_of(*at) == k);
  });
  if (!came_.empty()) {
    changed = true;
    blocks_.resize(kept + came_.size());
    // Merged from the back.
    for (std::size_t to = blocks_.size(), new_one = came_.size(); new_one > 0;) {
      const std::size_t k = came_[new_one - 1];
      if (kept > 0 && key_of(blocks_[kept - 1]) > k) {
        blocks_[--to] = blocks_[--kept];
      } else {
        const std::size_t cell = k % cells_;
        blocks_[--to] = {cell, grid.cell_nodes_of(cell), first_[k], count_of_cell_[k], static_cast<int>(k / cells_)};
        --new_one;
      }
    }
    came_.clear();
  }
  if (!changed) return;
  ++version_;
  for (std::size_t soil = 0; soil < soil_start_.size(); ++soil)
    soil_start_[soil] = static_cast<std::size_t>(
        std::partition_point(blocks_.begin(), blocks_.end(),
                             [&](const Block& block) { return static_cast<std::size_t>(block.soil) < soil; }) -
        blocks_.begin());
}

template <int dim>
std::span<const Block> MaterialPoints<dim>::blocks(int soil) const {
  const auto s = static_cast<std::size_t>(soil);
  if (s + 1 >= soil_start_.size()) return {};
  return std::span<const Block>(blocks_).subspan(soil_start_[s], soil_start_[s + 1] - soil_start_[s]);
}

template <int dim>
bool MaterialPoints<dim>::occupied(std::size_t cell) const {
  for (std::size_t k = cell; k < count_of_cell_.size(); k += cells_)
    if (count_of_cell_[k] > 0) return true;
  return false;
}

template <int dim>
Vector<dim> MaterialPoints<dim>::position(std::size_t slot) const {
  const Column& column = *columns.all().front();  // the first one made
  Vector<dim> x{};
  for (int a = 0; a < dim; ++a) x[a] = column[a][slot];
  return x;
}

template <int dim>
double MaterialPoints<dim>::sum(const Column& column) const {
  double total = 0;
  for (int c = 0; c < column.spec().components; ++c)
    for (const Block& block : blocks_)
      total = std::accumulate(column[c] + block.first, column[c] + block.first + block.count, total);
  return total;
}

template <int dim>
std::vector<double> MaterialPoints<dim>::in_order(const Column& column) const {
  std::vector<double> values;
  values.reserve(size_ * static_cast<std::size_t>(column.spec().components));
  for (int c = 0; c < column.spec().components; ++c)
    for (const Block& block : blocks_)
      values.insert(values.end(), column[c] + block.first, column[c] + block.first + block.count);
  return values;
}

template <int dim>
void MaterialPoints<dim>::put_in_order(std::span<const double> values, Column& column) const {
  const bool position = column.spec().name == "position";
  const double* next = values.data();
  for (int c = 0; c < column.spec().components; ++c)
    for (const Block& block : blocks_) {
      double* to = std::copy_n(next, block.count, column[c] + block.first);
      next += block.count;
      if (roomy_ && position)
        std::fill(to, column[c] + block.first + SlotRooms::rounded(block.count), column[c][block.first]);
    }
}

template class MaterialPoints<2>;
template class MaterialPoints<3>;

}  // namespace wetfront::mpm
