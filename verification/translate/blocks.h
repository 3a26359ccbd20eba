#pragma once

#include "meshes/mesh.h"
#include "verification/scene/geometry.h"

namespace wetfront::verification {

/// How finely a built-in shape is meshed.
struct BlockCells {
  int over;              ///< from base to surface
  int along_factor = 1;  ///< times the shape's own number along
  int halvings = 0;      ///< of every cell beyond that; -1, where can_coarsen(): cells twice as large
  double room = 0;       ///< height of more cells, as high as those below, above the surface [m]; in a plane only
};

/// Meshes a built-in shape such that cells follow whatever can be followed: boundaries of layers that stay inside the
/// ground, edges of zones and of parts of sides. Between these, cells are about equal; meshes of more halvings are
/// nested. The one region is "soil".
meshes::Mesh block_mesh(const Geometry& geometry, const BlockCells& cells);

/// The same for a column as a line (dimension 1), `cells` over its height.
meshes::Mesh line_mesh(const Geometry& geometry, int cells, int halvings);

/// Whether the mesh is another one with every cell halved.
bool can_coarsen(const Geometry& geometry, int over, int along_factor);

}  // namespace wetfront::verification
