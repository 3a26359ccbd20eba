#pragma once

#include "mpm/laws/tensor.h"
#include "mpm/problem.h"

#include <optional>
#include <string>
#include <vector>

/// One point of soil in a testing machine: a law taken along paths of strain, stress and suction.
namespace wetfront::mpm {

/// A leg of a path. Each component of the tensors (xx, yy, zz, xy, yz, zx; plane strain: the first four;
/// tension-positive, shear strain that of the tensor) is driven either by strain or, where `stress` has a value, by
/// stress.
template <int dim>
struct PathLeg {
  SymmetricTensor<dim> strain{};  ///< change over the leg of what is driven by strain [-]
  /// Effective stress at the end of the leg of what is driven by stress, reached in even steps [Pa].
  std::array<std::optional<double>, stress_components<dim>> stress{};
  std::optional<double> suction{};  ///< at the end of the leg, reached in even steps [Pa]; absent: as it was
  int steps = 100;
};

/// Where a path begins.
template <int dim>
struct PathStart {
  SymmetricTensor<dim> stress{};  ///< effective [Pa]
  double suction = 0;             ///< chi s [Pa]
};

template <int dim>
struct PathState {
  SymmetricTensor<dim> strain{};  ///< since the beginning [-]
  SymmetricTensor<dim> stress{};  ///< effective [Pa]
  std::vector<double> memory;     ///< as `path_memory` names it
  double suction = 0;
};

/// The states along a path, the first and one after each step. Steps have no rotation. Components driven by stress are
/// met to 1e-12 of the stress by Newton's method on the law itself (differences; halved steps where the law has a
/// corner). Throws CannotPlan when the soil has no law, std::runtime_error when a stress cannot be reached (the soil
/// fails before: drive that component by strain).
template <int dim>
std::vector<PathState<dim>> drive(const Soil& soil, const PathStart<dim>& start, const std::vector<PathLeg<dim>>& path);

/// Names of what the soil's law remembers, one per entry of PathState::memory.
template <int dim>
std::vector<std::string> path_memory(const Soil& soil);

/// Mean effective stress, compression-positive, and sqrt(3/2 s:s) of a stress [Pa].
struct PressureAndShear {
  double p, q;
};
PressureAndShear pressure_and_shear(const SymmetricTensor<3>& stress);

}  // namespace wetfront::mpm
