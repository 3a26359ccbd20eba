#pragma once

#include "meshes/mesh.h"
#include "verification/scene/scene.h"

namespace wetfront::verification {

/// The background grid of the material point method: quadrilaterals; a column is a strip one cell wide.
meshes::Mesh mpm_mesh(const Scene& scene);

/// The mesh of the reference: a line for a column, `cells` over its height; quadrilaterals otherwise.
meshes::Mesh reference_mesh(const Scene& scene, int cells);

}  // namespace wetfront::verification
