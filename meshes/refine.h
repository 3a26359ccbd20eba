#pragma once

#include "meshes/mesh.h"

namespace wetfront::meshes {

/// Every cell cut in half along each of its directions: 2, 4, 8 cells for one (dim 1, 2, 3). Regions and sides are
/// kept; new nodes lie at the middles of edges, faces and cells, so that nested fields can be compared node by node:
/// the old nodes keep their numbers, cell c becomes 2^dim c + i, i the corner where it lies, and its corner j is the
/// middle of corners i and j of the cell it came from. Faces of sides are cut by the same rule.
Mesh refined(const Mesh& mesh);

}  // namespace wetfront::meshes
