#pragma once

#include <experimental/simd>

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#ifdef __AVX__
#include <immintrin.h>
#endif

/// Four points at a time: the vector lanes of the block kernels (std::experimental::simd, Parallelism TS 2; one AVX
/// register where the machine has them). What is written for a number type T works for `double` and for `Lanes`.
namespace wetfront::mpm {

inline constexpr int lane_count = 4;
using Lanes = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, lane_count>>;
using LaneMask = Lanes::mask_type;

[[gnu::always_inline]] inline double select(bool where, double yes, double no) {
  return where ? yes : no;
}
[[gnu::always_inline]] inline Lanes select(const LaneMask& where, const Lanes& yes, const Lanes& no) {
  Lanes out = no;
  std::experimental::where(where, out) = yes;
  return out;
}
[[gnu::always_inline]] inline bool any(bool mask) {
  return mask;
}
[[gnu::always_inline]] inline bool any(const LaneMask& mask) {
  return std::experimental::any_of(mask);
}

[[gnu::always_inline]] inline Lanes load(const double* from) {
  return Lanes(from, std::experimental::element_aligned);
}
[[gnu::always_inline]] inline void store(const Lanes& value, double* to) {
  value.copy_to(to, std::experimental::element_aligned);
}
/// One entry of a column, or four: what `in_lanes` gives its body.
template <class Number>
[[gnu::always_inline]] inline Number load(const double* from) {
  if constexpr (std::is_same_v<Number, double>)
    return *from;
  else
    return load(from);
}
[[gnu::always_inline]] inline void store(double value, double* to) {
  *to = value;
}
/// body<Lanes>(i) for first, first + 4, ... and body<double>(i) for the rest below last.
template <class Body>
[[gnu::always_inline]] inline void in_lanes(std::size_t first, std::size_t last, const Body& body) {
  for (; first + lane_count <= last; first += lane_count) body.template operator()<Lanes>(first);
  for (; first < last; ++first) body.template operator()<double>(first);
}
[[gnu::always_inline]] inline double sum(const Lanes& value) {
  return (value[0] + value[1]) + (value[2] + value[3]);
}
/// The sums over the lanes of four values: (x0 + x1) + (x2 + x3) each, as `sum`.
[[gnu::always_inline]] inline Lanes sums(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
#ifdef __AVX__
  const __m256d ab = _mm256_hadd_pd(static_cast<__m256d>(a), static_cast<__m256d>(b));
  const __m256d cd = _mm256_hadd_pd(static_cast<__m256d>(c), static_cast<__m256d>(d));
  return Lanes(_mm256_add_pd(_mm256_permute2f128_pd(ab, cd, 0x20), _mm256_permute2f128_pd(ab, cd, 0x31)));
#else
  Lanes out;
  out[0] = sum(a), out[1] = sum(b), out[2] = sum(c), out[3] = sum(d);
  return out;
#endif
}
/// Adds the sum over the lanes of values[i] to to[node(i)].
template <std::size_t count, class Node>
[[gnu::always_inline]] inline void add_sums(const std::array<Lanes, count>& values, double* to, const Node& node) {
  alignas(32) double out[(count + 3) / 4 * 4];
  const auto value = [&](std::size_t k) { return k < count ? values[k] : Lanes(0.0); };
#pragma GCC unroll 8
  for (std::size_t k = 0; k < count; k += 4) store(sums(value(k), value(k + 1), value(k + 2), value(k + 3)), out + k);
#pragma GCC unroll 32
  for (std::size_t k = 0; k < count; ++k) to[node(static_cast<int>(k))] += out[k];
}

/// body(0), body(1), ... body(count-1) with constants: a loop that leaves no loop, so that arrays stay in registers.
template <int count, class Body>
[[gnu::always_inline]] inline constexpr void each(const Body& body) {
  // Longer ones stay loops: seven laws with 27 nodes unrolled take a compiler a quarter of an hour.
  if constexpr (count > 4) {
    for (int k = 0; k < count; ++k) body(k);
  } else {
    [&body]<int... k>(std::integer_sequence<int, k...>) __attribute__((always_inline)) {
      (body(std::integral_constant<int, k>{}), ...);
    }
    (std::make_integer_sequence<int, count>{});
  }
}

// The functions of a number type by one name: `using std::sqrt` for double, the library's for Lanes (found by
// argument).
using std::abs;
using std::max;
using std::min;
using std::sqrt;

}  // namespace wetfront::mpm
