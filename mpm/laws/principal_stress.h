#pragma once

#include "mpm/lanes.h"
#include "mpm/laws/tensor.h"

#include <cmath>
#include <limits>

namespace wetfront::mpm {

/// Principal values in falling order (tension-positive: the first is the least compressed) and what is needed to turn
/// changed values back into a tensor with the same axes. T is `double` or `Lanes`; no branch per lane.
template <int dim, class T>
class Principal;

/// Plane strain: the two of the plane, mean +- radius, and zz.
template <class T>
class Principal<2, T> {
 public:
  [[gnu::always_inline]] explicit Principal(const SymmetricTensor<2, T>& tensor)
      : half_difference_((tensor[0] - tensor[1]) * 0.5), shear_(tensor[3]), out_of_plane_(tensor[2]) {
    const T mean = (tensor[0] + tensor[1]) * 0.5;
    radius_ = sqrt(half_difference_ * half_difference_ + shear_ * shear_);
    larger_ = mean + radius_;
    smaller_ = mean - radius_;
    values = {max(larger_, out_of_plane_), max(smaller_, min(larger_, out_of_plane_)), min(smaller_, out_of_plane_)};
  }
  /// The tensor with the present `values` on the axes of the original one.
  [[gnu::always_inline]] SymmetricTensor<2, T> tensor() const {
    const auto zz_largest = out_of_plane_ > larger_, zz_smallest = out_of_plane_ < smaller_;
    const T larger = select(zz_largest, values[1], values[0]);
    const T smaller = select(zz_smallest, values[1], values[2]);
    const T zz = select(zz_largest, values[0], select(zz_smallest, values[2], values[1]));
    // Equal principal values have no axes and stay equal, so the ratio does not matter there.
    const T ratio = (larger - smaller) * 0.5 / max(radius_, T(std::numeric_limits<double>::min()));
    const T mean = (larger + smaller) * 0.5, difference = half_difference_ * ratio;
    return {mean + difference, mean - difference, zz, shear_ * ratio};
  }

  std::array<T, 3> values;

 private:
  T half_difference_, shear_, out_of_plane_, radius_, larger_, smaller_;
};

/// Three dimensions: Jacobi's rotations (Golub & Van Loan, section 8.5), which converge quadratically and keep axes
/// orthogonal to round-off, also where values coincide.
template <class T>
class Principal<3, T> {
 public:
  explicit Principal(const SymmetricTensor<3, T>& tensor)
      : diagonal_{tensor[0], tensor[1], tensor[2]}, off_{tensor[3], tensor[4], tensor[5]} {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) axis_[a][b] = T(a == b ? 1.0 : 0.0);
    const T size =
        abs(diagonal_[0]) + abs(diagonal_[1]) + abs(diagonal_[2]) + abs(off_[0]) + abs(off_[1]) + abs(off_[2]);
    const auto coupled = [&] { return any(abs(off_[0]) + abs(off_[1]) + abs(off_[2]) > size * 1e-16); };
    // Quadratic convergence: four or five sweeps; the bound is for numbers that are not finite.
    for (int sweep = 0; sweep < 12 && coupled(); ++sweep) {
      turn(0, 1, off_[0], off_[2], off_[1]);
      turn(1, 2, off_[1], off_[0], off_[2]);
      turn(2, 0, off_[2], off_[1], off_[0]);
    }
    sort();
  }
  SymmetricTensor<3, T> tensor() const {
    const auto entry = [this](int a, int b) {
      return axis_[a][0] * values[0] * axis_[b][0] + axis_[a][1] * values[1] * axis_[b][1] +
             axis_[a][2] * values[2] * axis_[b][2];
    };
    return {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(1, 2), entry(2, 0)};
  }
  /// Component a of the axis of values[k].
  T axis(int a, int k) const { return axis_[a][k]; }

  std::array<T, 3> values{};

 private:
  /// Makes the entry (p, q) zero; `with_p`, `with_q` are the entries of p and of q with the third axis.
  void turn(int p, int q, T& entry, T& with_p, T& with_q) {
    const auto none = abs(entry) < T(std::numeric_limits<double>::min());
    const T theta = (diagonal_[q] - diagonal_[p]) * 0.5 / select(none, T(1.0), entry);
    const T magnitude = T(1.0) / (abs(theta) + sqrt(theta * theta + 1.0));
    const T tangent = select(none, T(0.0), select(theta < 0.0, -magnitude, magnitude));
    const T c = T(1.0) / sqrt(tangent * tangent + 1.0), s = tangent * c;
    diagonal_[p] -= tangent * entry;
    diagonal_[q] += tangent * entry;
    entry = T(0.0);
    const T first = with_p * c - with_q * s;
    with_q = with_p * s + with_q * c;
    with_p = first;
    for (int a = 0; a < 3; ++a) {
      const T turned = axis_[a][p] * c - axis_[a][q] * s;
      axis_[a][q] = axis_[a][p] * s + axis_[a][q] * c;
      axis_[a][p] = turned;
    }
  }
  void exchange(int p, int q) {
    const auto wrong = diagonal_[p] < diagonal_[q];
    const auto swap = [&wrong](T& first, T& second) {
      const T larger = select(wrong, second, first);
      second = select(wrong, first, second);
      first = larger;
    };
    swap(diagonal_[p], diagonal_[q]);
    for (int a = 0; a < 3; ++a) swap(axis_[a][p], axis_[a][q]);
  }
  void sort() {
    exchange(0, 1);
    exchange(1, 2);
    exchange(0, 1);
    values = diagonal_;
  }

  std::array<T, 3> diagonal_;
  std::array<T, 3> off_;  ///< xy, yz, zx
  std::array<std::array<T, 3>, 3> axis_;
};

}  // namespace wetfront::mpm
