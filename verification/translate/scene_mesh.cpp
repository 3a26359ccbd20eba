#include "verification/translate/scene_mesh.h"

#include "meshes/geo_script.h"
#include "meshes/gmsh.h"
#include "meshes/read_msh.h"
#include "meshes/refine.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

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

/// A sparse direct solve per Newton step: beyond this a reference takes hours and all the memory.
constexpr double most_cells = 150000;

void require_affordable(const Scene& scene, double cells, const std::string& suggestion) {
  if (cells <= most_cells) return;
  const std::string place = scene.reference ? scene.reference->origin.text() : scene.path.string() + ":1:1";
  throw std::runtime_error(place + ": the reference would have " + std::to_string(static_cast<long>(cells)) +
                           " cells (it would run for hours; " + std::to_string(static_cast<long>(most_cells)) +
                           " are allowed). Set [reference] cells to e.g. " + suggestion);
}

/// Halvings of a mesh's own cells until there are at least `cells`.
int halvings_to(const meshes::Mesh& mesh, int cells) {
  int halvings = 0;
  for (double count = mesh.cell_count(); count < cells; count *= 1 << mesh.dim) ++halvings;
  return halvings;
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

bool can_coarsen(const Scene& scene, int cells) {
  if (std::holds_alternative<Column>(scene.geometry.shape)) return cells % 2 == 0;
  if (const auto* slope = std::get_if<Slope>(&scene.geometry.shape)) return cells % (2 * slope->cells_over) == 0;
  return halvings_to(user_mesh(scene, std::get<MeshFile>(scene.geometry.shape)), cells) > 0;
}

meshes::Mesh reference_mesh(const Scene& scene, int cells, int halvings) {
  const int finest = halvings < 0 ? cells >> -halvings : cells << halvings;
  if (const auto* column = std::get_if<Column>(&scene.geometry.shape))
    return meshes::generate(meshes::line_column_script(column->height, finest), 1);
  if (const auto* slope = std::get_if<Slope>(&scene.geometry.shape)) {
    require_affordable(scene, double(finest) * slope->cells_along * std::max(1, finest / slope->cells_over),
                       std::to_string(2 * slope->cells_over) + ", twice the candidate's " +
                           std::to_string(slope->cells_over) + " over the thickness");
    return slope_mesh(*slope, finest);
  }
  meshes::Mesh mesh = user_mesh(scene, std::get<MeshFile>(scene.geometry.shape));
  const int total = halvings_to(mesh, cells) + halvings;
  require_affordable(scene, mesh.cell_count() * std::exp2(mesh.dim * total), "the mesh's own number");
  for (int i = 0; i < total; ++i) mesh = meshes::refined(mesh);
  meshes::renumber_by_position(mesh);
  return mesh;
}

}  // namespace wetfront::verification
