#pragma once

#include "mpm/grid/material_points.h"

#include <functional>
#include <span>
#include <vector>

namespace wetfront::mpm {

/// Cells in runs of equal length, coloured so that runs of one colour share no node: their sums at the nodes may be
/// made at the same time, and have one order whatever the number of threads. The runs are those of the mesh; which
/// blocks lie in them is found anew when cells become occupied or empty.
template <int dim>
class Chunks {
 public:
  /// `nodes_of(cell)` lists the nodes that a cell's points act on.
  Chunks(std::size_t cells, std::size_t nodes, const std::function<std::vector<int>(std::size_t)>& nodes_of);

  std::size_t size() const { return chunks_; }
  /// Chunks of each colour, colour after colour.
  const std::vector<std::vector<std::size_t>>& colours() const { return colours_; }
  void update(const MaterialPoints<dim>& points, int soils);
  std::span<const Block> blocks(const MaterialPoints<dim>& points, std::size_t chunk, int soil) const {
    const std::size_t* range = &ranges_[static_cast<std::size_t>(soil) * (chunks_ + 1) + chunk];
    return points.blocks(soil).subspan(range[0], range[1] - range[0]);
  }

 private:
  std::size_t cells_per_chunk_, chunks_;
  std::vector<std::vector<std::size_t>> colours_;
  std::vector<std::size_t> ranges_;  ///< per soil: first block of each chunk, and the end
};

}  // namespace wetfront::mpm
