#include "mpm/grid/chunks.h"

#include <algorithm>

namespace wetfront::mpm {

namespace {

// Few enough to keep their bookkeeping free, many enough for threads to share; a short chunk is not worth a hand-over.
constexpr std::size_t most_chunks = 128, least_cells = 256;

}  // namespace

template <int dim>
Chunks<dim>::Chunks(std::size_t cells, std::size_t nodes, const std::function<std::vector<int>(std::size_t)>& nodes_of)
    : cells_per_chunk_(std::max(least_cells, (cells + most_chunks - 1) / most_chunks)),
      chunks_((cells + cells_per_chunk_ - 1) / cells_per_chunk_) {
  // Chunks at each node, then the first colour that no neighbour has.
  std::vector<std::vector<std::size_t>> at_node(nodes), neighbours(chunks_);
  for (std::size_t cell = 0; cell < cells; ++cell)
    for (int node : nodes_of(cell)) {
      auto& chunks = at_node[static_cast<std::size_t>(node)];
      const std::size_t chunk = cell / cells_per_chunk_;
      if (chunks.empty() || chunks.back() != chunk) chunks.push_back(chunk);
    }
  for (const auto& chunks : at_node)
    for (std::size_t a : chunks)
      for (std::size_t b : chunks)
        if (a != b) neighbours[a].push_back(b);
  std::vector<std::size_t> colour(chunks_, 0);
  for (std::size_t chunk = 0; chunk < chunks_; ++chunk) {
    std::vector<char> taken(chunks_ + 1, 0);
    for (std::size_t other : neighbours[chunk])
      if (other < chunk) taken[colour[other]] = 1;
    colour[chunk] = static_cast<std::size_t>(std::find(taken.begin(), taken.end(), 0) - taken.begin());
    if (colour[chunk] >= colours_.size()) colours_.resize(colour[chunk] + 1);
    colours_[colour[chunk]].push_back(chunk);
  }
}

template <int dim>
void Chunks<dim>::update(const MaterialPoints<dim>& points, int soils) {
  ranges_.resize(static_cast<std::size_t>(soils) * (chunks_ + 1));
  for (int soil = 0; soil < soils; ++soil) {
    const auto blocks = points.blocks(soil);
    for (std::size_t chunk = 0; chunk <= chunks_; ++chunk)
      ranges_[static_cast<std::size_t>(soil) * (chunks_ + 1) + chunk] = static_cast<std::size_t>(
          std::partition_point(blocks.begin(), blocks.end(),
                               [&](const Block& block) { return block.cell < chunk * cells_per_chunk_; }) -
          blocks.begin());
  }
}

template class Chunks<2>;
template class Chunks<3>;

}  // namespace wetfront::mpm
