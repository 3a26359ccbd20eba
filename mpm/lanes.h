#pragma once

#include <experimental/simd>

#include <cmath>

/// Four points at a time: the vector lanes of the block kernels (std::experimental::simd, Parallelism TS 2; one AVX
/// register where the machine has them). What is written for a number type T works for `double` and for `Lanes`.
namespace wetfront::mpm {

inline constexpr int lane_count = 4;
using Lanes = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, lane_count>>;
using LaneMask = Lanes::mask_type;

inline double select(bool where, double yes, double no) {
  return where ? yes : no;
}
inline Lanes select(const LaneMask& where, const Lanes& yes, const Lanes& no) {
  Lanes out = no;
  std::experimental::where(where, out) = yes;
  return out;
}
inline bool any(bool mask) {
  return mask;
}
inline bool any(const LaneMask& mask) {
  return std::experimental::any_of(mask);
}

inline Lanes load(const double* from) {
  return Lanes(from, std::experimental::element_aligned);
}
inline void store(const Lanes& value, double* to) {
  value.copy_to(to, std::experimental::element_aligned);
}
inline double sum(const Lanes& value) {
  return std::experimental::reduce(value);
}

// The functions of a number type by one name: `using std::sqrt` for double, the library's for Lanes (found by
// argument).
using std::abs;
using std::max;
using std::min;
using std::sqrt;

}  // namespace wetfront::mpm
