#pragma once

#include "mpm/skeleton/linear_shape.h"

#include <array>

#ifdef __AVX__
#include <immintrin.h>
#endif

/// Sums over four points of a cell at a time.
namespace wetfront::mpm {

/// Sums over the lanes of four vectors, as one vector.
inline Lanes lane_sums(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
#ifdef __AVX__
  const __m256d ab = _mm256_hadd_pd(static_cast<__m256d>(a), static_cast<__m256d>(b)),
                cd = _mm256_hadd_pd(static_cast<__m256d>(c), static_cast<__m256d>(d));
  return Lanes(_mm256_add_pd(_mm256_permute2f128_pd(ab, cd, 0x21), _mm256_blend_pd(ab, cd, 0b1100)));
#else
  const double sums[lane_count] = {sum(a), sum(b), sum(c), sum(d)};
  return load(sums);
#endif
}

/// Per node of a cell, the sum over its points of quantity * N_i.
template <int dim>
struct NodeSums {
  static constexpr int groups = cell_nodes<dim> / lane_count;
  std::array<Lanes, groups> part{};

  void add(const Lanes& quantity, const std::array<Lanes, cell_nodes<dim>>& shape) {
    for (int g = 0; g < groups; ++g)
      part[g] += lane_sums(quantity * shape[4 * g], quantity * shape[4 * g + 1], quantity * shape[4 * g + 2],
                           quantity * shape[4 * g + 3]);
  }
  void copy_to(double* nodes) const {
    for (int g = 0; g < groups; ++g) store(part[g], nodes + lane_count * g);
  }
};

}  // namespace wetfront::mpm
