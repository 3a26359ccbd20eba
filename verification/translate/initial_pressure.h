#pragma once

#include "meshes/mesh.h"
#include "verification/scene/scene.h"

#include <vector>

namespace wetfront::verification {

/// Whether the start is the reference's own work: steady antecedent rain, spin-up.
bool start_is_computed(const Scene& scene);

/// Pore pressure of the scene's initial state at every node [Pa, compression-positive]. Hydrostatic: rho g (water table
/// - elevation), along the vertical also where the table is a line, not below minus the suction cap. A computed start
/// is computed on the reference's mesh, once per scene, and interpolated. Throws std::runtime_error for a field that
/// cannot be read.
std::vector<double> initial_pressure(const Scene& scene, const meshes::Mesh& mesh);

/// The same at a node at rest over a water table.
std::vector<double> hydrostatic_pressure(const Scene& scene, const HydrostaticStart& start, const meshes::Mesh& mesh);

/// Magnitude of gravity [m/s2].
double gravity_magnitude(const Scene& scene);

/// Height of a mesh's point above the origin, against gravity [m].
double elevation(const Scene& scene, const meshes::Point& point, int dim);

}  // namespace wetfront::verification
