#pragma once

#include "mpm/grid/vector.h"

#include <span>

namespace wetfront::mpm {

/// Rigid planes at a node: outward normals n_k of length 1, and how fast the body may still come nearer,
/// gap_k/dt >= 0 [m/s].
template <int dim>
struct RigidPlanes {
  std::span<const Vector<dim>> normal;
  std::span<const double> approach;
};

/// Velocity after contact with rigid planes: the nearest one with v.n_k <= gap_k/dt for all of them. `impulse[k]` >= 0
/// is what plane k took away [m/s]. Planes are few (corners), so every set of at most `dim` active ones is tried; by
/// convexity one of them fits.
template <int dim>
Vector<dim> without_penetration(const Vector<dim>& velocity, const RigidPlanes<dim>& planes, std::span<double> impulse);

/// Without its parts along the normals of the planes that took something away.
template <int dim>
Vector<dim> along_planes(const Vector<dim>& velocity, const RigidPlanes<dim>& planes, std::span<const double> impulse);

}  // namespace wetfront::mpm
