#pragma once

#include "meshes/mesh.h"
#include "verification/scene/scene.h"

#include <vector>

namespace wetfront::verification {

/// Pore pressure of the scene's initial state at a point [Pa, compression-positive].
/// Hydrostatic: rho g (water table - elevation), not below minus the suction cap. In a one-dimensional mesh the
/// only coordinate is the elevation.
double initial_pressure(const Scene& scene, const meshes::Point& point, int dim);

/// The same at every node.
std::vector<double> initial_pressure(const Scene& scene, const meshes::Mesh& mesh);

/// Magnitude of gravity [m/s2].
double gravity_magnitude(const Scene& scene);

}  // namespace wetfront::verification
