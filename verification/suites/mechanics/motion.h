#pragma once

#include "meshes/field_history.h"
#include "mpm/laws/tensor.h"
#include "mpm/problem.h"

#include <array>
#include <functional>
#include <vector>

namespace wetfront::verification {

/// Where the material points are and what they carry at one time. Empty: not carried.
template <int dim>
struct Cloud {
  using Vector = std::array<double, dim>;
  double time = 0;
  std::vector<Vector> position, velocity;
  std::vector<Vector> origin;  ///< where each point began; kept where there is a body acceleration
  std::vector<mpm::SymmetricTensor<dim>> stress;
  std::vector<double> volume, mass, pressure, water;

  std::size_t size() const { return position.size(); }
  double total_mass() const;
  /// Mass-weighted mean over the points of f(point index).
  double mean(const std::function<double(std::size_t)>& f) const;
  double mean_velocity(int axis) const;
  double kinetic_energy() const;
  double highest(int axis) const;  ///< largest coordinate along an axis
};

/// A run with its material points at every output time.
template <int dim>
struct Motion {
  meshes::FieldHistory history;
  Cloud<dim> start;  ///< before the first step
  std::vector<Cloud<dim>> clouds;
  double steps = 0;
  std::size_t points = 0;
};

/// Runs a problem to its end, or until `enough` says so (it sees the clouds so far). Throws mpm::CannotPlan,
/// mpm::GaveUp.
template <int dim>
Motion<dim> move(const mpm::Problem<dim>& problem, const std::function<bool(const Cloud<dim>&)>& enough = nullptr);

}  // namespace wetfront::verification
