#include "verification/translate/scene_mesh.h"

#include "meshes/geo_script.h"
#include "meshes/gmsh.h"
#include "meshes/read_msh.h"

#include <algorithm>

namespace wetfront::verification {
namespace {

meshes::Mesh user_mesh(const Scene& scene, const MeshFile& file) {
  const auto path = file.path.is_absolute() ? file.path : scene.path.parent_path() / file.path;
  meshes::Mesh mesh = meshes::read_msh(path);
  meshes::renumber_by_position(mesh);
  meshes::validate(mesh);
  return mesh;
}

meshes::Mesh slope_mesh(const Slope& slope, int cells_over) {
  const int along = slope.cells_along * std::max(1, cells_over / slope.cells_over);
  return meshes::generate(meshes::slope_script({slope.length, slope.thickness, slope.angle, along, cells_over}), 2);
}

}  // namespace

meshes::Mesh mpm_mesh(const Scene& scene) {
  if (const auto* column = std::get_if<Column>(&scene.geometry.shape)) {
    const double width = column->height / column->cells;  // square cells
    return meshes::generate(meshes::strip_column_script(column->height, width, column->cells), 2);
  }
  if (const auto* slope = std::get_if<Slope>(&scene.geometry.shape)) return slope_mesh(*slope, slope->cells_over);
  return user_mesh(scene, std::get<MeshFile>(scene.geometry.shape));
}

meshes::Mesh reference_mesh(const Scene& scene, int cells) {
  if (const auto* column = std::get_if<Column>(&scene.geometry.shape))
    return meshes::generate(meshes::line_column_script(column->height, cells), 1);
  if (const auto* slope = std::get_if<Slope>(&scene.geometry.shape)) return slope_mesh(*slope, cells);
  return user_mesh(scene, std::get<MeshFile>(scene.geometry.shape));
}

}  // namespace wetfront::verification
