#pragma once

#include "meshes/mesh.h"
#include "verification/scene/scene.h"

namespace wetfront::verification {

/// Height of the empty cells above the surface in the mesh of the points [m]; 0: none.
double room(const Scene& scene);

/// The background grid of the material point method: quadrilaterals; a column is a strip one cell wide. Its topmost row
/// reaches above the ground where the surface lies inside it, and there is room() above a profile.
meshes::Mesh mpm_mesh(const Scene& scene);

/// The line of the ground, from left to right [m], where it does not follow the sides of cells: inside the topmost row
/// ([mpm] surface_in_cell), or with empty cells above its soil; else empty.
std::vector<meshes::Point> surface_inside_cells(const Scene& scene);

/// The mesh of the reference: a line for a column, `cells` over its height; quadrilaterals (hexahedra) for the other
/// built-in shapes, `cells` from base to surface; the user's own mesh, halved until it has at least `cells` cells. Then
/// every cell is halved `halvings` times more; -1, where can_coarsen(): cells twice as large. Regions and parts of
/// sides are the scene's. Throws std::runtime_error when that makes more cells than a reference can be solved on.
meshes::Mesh reference_mesh(const Scene& scene, int cells, int halvings);

/// Cells of the shape from base to surface; 0 for a mesh file.
int own_cells_over(const Scene& scene);

/// Whether the reference's mesh of that resolution is another one with every cell halved.
bool can_coarsen(const Scene& scene, int cells);

}  // namespace wetfront::verification
