#pragma once

#include "meshes/mesh.h"

namespace wetfront::meshes {

/// Every cell cut in half along each of its directions: 2, 4 cells for one (dim 1, 2). Regions and sides are kept; new
/// nodes lie at the middles of edges and at cell centres, so that nested fields can be compared node by node.
/// Throws std::invalid_argument in three dimensions.
Mesh refined(const Mesh& mesh);

}  // namespace wetfront::meshes
