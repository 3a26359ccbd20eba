#pragma once

#include "mpm/skeleton/gather_cell.h"

#include <span>

namespace wetfront::mpm {

/// MUSL (Eq. 14) for quadrilaterals without a look at their points, which take their new velocities only when they
/// move:
///   sum_p m_p N_i (k v_p + sum_j N_j g_j) = k (m v)_i + sum_j M_ij g_j,
/// where "velocity" of the nodes holds k (m v)_i and the points stay where they were when M_ij was summed.
class BackQuads {
 public:
  BackQuads(const LinearShape<2>& shape, const SkeletonColumns& columns, const CellMass* masses)
      : shape_(shape), node_(columns), masses_(masses) {}

  void operator()(std::span<const Block> blocks) {
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      shape_.enter(blocks[k]);
      const auto& column = masses_[k].column;
      each<2>([&](auto a) __attribute__((always_inline)) {
        const auto part = [&](int j) __attribute__((always_inline)) {
          return load(column[static_cast<std::size_t>(j)].data()) * node_.gain[a][shape_.node(j)];
        };
        shape_.add_to_nodes((part(0) + part(1)) + (part(2) + part(3)), node_.velocity[a]);
      });
    }
  }

 private:
  LinearShape<2> shape_;
  NodePlaces<2> node_;
  const CellMass* masses_;
};

}  // namespace wetfront::mpm
