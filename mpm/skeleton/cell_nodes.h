#pragma once

#include "mpm/grid/stencil.h"
#include "mpm/lanes.h"

namespace wetfront::mpm {

/// The nodes of a cell in lanes: what a column holds there, and what a cell adds to it.
template <int dim>
class CellNodes {
 public:
  static constexpr int nodes = cell_nodes<dim>, groups = nodes / lane_count;
  using Values = std::array<Lanes, groups>;

  CellNodes() = default;
  [[gnu::always_inline]] explicit CellNodes(const int* node)
      : node_(node), in_rows_(dim == 2 && node[1] == node[0] + 1 && node[2] == node[3] + 1) {}
  int operator[](int i) const { return node_[i]; }

  [[gnu::always_inline]] Values of(const double* column) const {
#ifdef __AVX__
    if (in_rows_) {
      const __m128d top = _mm_loadu_pd(column + node_[3]);
      return {Lanes(_mm256_set_m128d(_mm_shuffle_pd(top, top, 1), _mm_loadu_pd(column + node_[0])))};
    }
#endif
    Values out;
    for (int g = 0; g < groups; ++g)
      out[g] = Lanes([&](auto lane) { return column[node_[lane_count * g + static_cast<int>(lane)]]; });
    return out;
  }
  [[gnu::always_inline]] void add(const Values& value, double* column) const {
#ifdef __AVX__
    if (in_rows_) {
      const __m256d v = static_cast<__m256d>(value[0]);
      double *low = column + node_[0], *high = column + node_[3];
      _mm_storeu_pd(low, _mm_add_pd(_mm_loadu_pd(low), _mm256_castpd256_pd128(v)));
      const __m128d top = _mm256_extractf128_pd(v, 1);
      _mm_storeu_pd(high, _mm_add_pd(_mm_loadu_pd(high), _mm_shuffle_pd(top, top, 1)));
      return;
    }
#endif
    for (int g = 0; g < groups; ++g)
      for (int i = 0; i < lane_count; ++i) column[node_[lane_count * g + i]] += value[g][static_cast<std::size_t>(i)];
  }

 private:
  const int* node_ = nullptr;
  bool in_rows_ = false;  ///< the nodes of a quadrilateral are numbered along its two rows
};

}  // namespace wetfront::mpm
