#pragma once

#include "meshes/mesh.h"
#include "verification/scene/scene.h"

namespace wetfront::verification {

/// The background grid of the material point method: quadrilaterals; a column is a strip one cell wide.
meshes::Mesh mpm_mesh(const Scene& scene);

/// The mesh of the reference: a line for a column, `cells` over its height; quadrilaterals for a slope, `cells` over
/// its thickness; the user's own mesh, halved until it has at least `cells` cells. Then every cell is halved `halvings`
/// times more. Throws std::runtime_error when that makes more cells than a reference can be solved on.
/// `halvings` = -1, where can_coarsen(): cells twice as large.
meshes::Mesh reference_mesh(const Scene& scene, int cells, int halvings);

/// Whether the reference's mesh of that resolution is another one with every cell halved.
bool can_coarsen(const Scene& scene, int cells);

}  // namespace wetfront::verification
