#pragma once

#include "mpm/grid/material_points.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

/// Cells whose points may belong to several soils.
namespace wetfront::mpm {

/// The block of a soil in a cell; null: none of its points are there.
template <int dim>
const Block* find_block(const MaterialPoints<dim>& points, std::size_t cell, int soil) {
  const std::span<const Block> all = points.blocks(soil);
  const auto at = std::ranges::lower_bound(all, cell, {}, &Block::cell);
  return at != all.end() && at->cell == cell ? &*at : nullptr;
}

/// One more than the last soil that has points.
template <int dim>
int soil_count(const MaterialPoints<dim>& points) {
  return points.blocks().empty() ? 0 : points.blocks().back().soil + 1;
}

/// Calls `body` with the blocks of each occupied cell, one per soil that has points in it: cells in the order of
/// blocks() by the first of theirs, so that where no cell has two soils this is the order of blocks().
template <int dim, class Body>
void each_cell(const MaterialPoints<dim>& points, Body&& body) {
  const int soils = soil_count(points);
  std::array<const Block*, 8> few;  // no allocation in a step: more soils than these are hardly in a scene
  std::vector<const Block*> many(soils > 8 ? static_cast<std::size_t>(soils) : 0);
  const Block** const in_cell = many.empty() ? few.data() : many.data();
  for (const Block& block : points.blocks()) {
    bool first = true;
    for (int soil = 0; soil < block.soil && first; ++soil) first = find_block(points, block.cell, soil) == nullptr;
    if (!first) continue;
    std::size_t count = 0;
    in_cell[count++] = &block;
    for (int soil = block.soil + 1; soil < soils; ++soil)
      if (const Block* other = find_block(points, block.cell, soil)) in_cell[count++] = other;
    body(std::span<const Block* const>(in_cell, count));
  }
}

/// The soil at a place in a cell: that of the nearest of the cell's points; -1: the cell has none.
template <int dim>
int soil_at(const MaterialPoints<dim>& points, std::size_t cell, const Vector<dim>& x) {
  std::vector<const Block*> in_cell;
  for (int soil = 0; soil < soil_count(points); ++soil)
    if (const Block* block = find_block(points, cell, soil)) in_cell.push_back(block);
  if (in_cell.size() < 2) return in_cell.empty() ? -1 : in_cell.front()->soil;
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const Block* block : in_cell)
    for (std::size_t p = block->first; p < block->first + block->count; ++p) {
      const Vector<dim> there = points.position(p);
      double square = 0;
      for (int a = 0; a < dim; ++a) square += (there[a] - x[a]) * (there[a] - x[a]);
      if (square < least) least = square, nearest = block->soil;
    }
  return nearest;
}

/// The soil that fills most of a cell (of equals the lower index); -1: the cell has no points.
template <int dim>
int main_soil(const MaterialPoints<dim>& points, std::size_t cell) {
  const double* volume = (*points.columns.find("volume"))[0];
  int most = -1;
  double largest = 0;
  for (int soil = 0; soil < soil_count(points); ++soil) {
    const Block* block = find_block(points, cell, soil);
    if (block == nullptr) continue;
    const double held = std::accumulate(volume + block->first, volume + block->first + block->count, 0.0);
    if (held > largest) largest = held, most = soil;
  }
  return most;
}

}  // namespace wetfront::mpm
