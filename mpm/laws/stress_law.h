#pragma once

#include "mpm/laws/tensor.h"
#include "mpm/plan/column.h"

#include <concepts>
#include <vector>

/// Laws of the skeleton: effective stress, tension-positive, from the motion of a step.
///
/// Adding one takes a file here with a type that satisfies `StressLaw`, its parameters in problem.h (SkeletonLaw) and a
/// line in stress_laws.h. modified_cam_clay.h is the worked example.
namespace wetfront::mpm {

/// What a point is and remembers, as its law sees it. T is `double` or `Lanes`.
template <class Law, int dim, class T = double>
struct LawPoint {
  SymmetricTensor<dim, T> stress{};  ///< effective, Cauchy [Pa]
  std::array<T, Law::template memory_size<dim>> memory{};
  T suction{};  ///< chi s >= 0 [Pa]; given only where Law::needs_suction
};

/// `advance` takes the stress from the beginning of a step to its end: rotation and strain of the step's gradient
/// (rotate.h, tensor.h), return to the yield surface, memory. Written once for any number type.
/// `memory_specs(dim)` names the columns of the memory, in order; `begin` sets the memory of an unstrained point.
/// `constrained_modulus` (E_oed, tangent, elastic [Pa]) sets the wave speed; it may depend on the point.
template <class Law, int dim>
concept StressLaw = requires(const Law& law, LawPoint<Law, dim>& point, const StepGradient<dim>& step) {
  { Law::template memory_size<dim> } -> std::convertible_to<int>;
  { Law::needs_suction } -> std::convertible_to<bool>;
  { Law::memory_specs(dim) } -> std::convertible_to<std::vector<ColumnSpec>>;
  law.begin(point);
  law.advance(point, step);
  { law.constrained_modulus(point) } -> std::convertible_to<double>;
};

/// What a law without memory has to say of it; laws derive from this.
struct NoMemory {
  template <int dim>
  static constexpr int memory_size = 0;
  static constexpr bool needs_suction = false;
  static std::vector<ColumnSpec> memory_specs(int) { return {}; }

  template <class Law, int dim, class T>
  void begin(LawPoint<Law, dim, T>&) const {}
};

}  // namespace wetfront::mpm
