#pragma once

#include "meshes/mesh.h"

#include <array>
#include <functional>

namespace wetfront::verification {

/// A box from the origin, `size` [m], `cells` equal cells along each of the first `dim` axes; the last of them points
/// up. Sides "base", "top"; in two dimensions also "left", "right"; in three "front", "back" (along the second axis).
/// One region, "soil".
meshes::Mesh box_mesh(int dim, const std::array<double, 3>& size, const std::array<int, 3>& cells);

inline meshes::Mesh line_mesh(double height, int cells) {
  return box_mesh(1, {height, 0, 0}, {cells, 1, 1});
}
inline meshes::Mesh rectangle_mesh(double width, double height, int along, int over) {
  return box_mesh(2, {width, height, 0}, {along, over, 1});
}

/// The region of each cell from its centre; `names` are the regions'.
void name_regions(meshes::Mesh& mesh, std::vector<std::string> names,
                  const std::function<int(const meshes::Point&)>& region_at);

/// Moves the faces of `side` whose centre satisfies `part` to a new side of that name.
void split_side(meshes::Mesh& mesh, const std::string& side, const std::string& name,
                const std::function<bool(const meshes::Point&)>& part);

}  // namespace wetfront::verification
