#include "verification/translate/scene_mesh.h"

#include "meshes/gmsh.h"
#include "meshes/read_msh.h"
#include "meshes/refine.h"
#include "verification/translate/blocks.h"
#include "verification/translate/lay_soils.h"

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

/// A sparse direct solve per Newton step: beyond this a reference takes hours and all the memory.
constexpr double most_cells = 150000;

void require_affordable(const Scene& scene, double cells, const std::string& suggestion) {
  if (cells <= most_cells) return;
  const std::string place = scene.reference ? scene.reference->origin.text() : scene.path.string() + ":1:1";
  throw std::runtime_error(place + ": the reference would have " + std::to_string(static_cast<long>(cells)) +
                           " cells (it would run for hours; " + std::to_string(static_cast<long>(most_cells)) +
                           " are allowed). Set [reference] cells to e.g. " + suggestion);
}

/// Cells of the shape from base to surface; 0 for a mesh file.
int own_cells_over(const Geometry& geometry) {
  if (const auto* column = std::get_if<Column>(&geometry.shape)) return column->cells;
  if (const auto* slope = std::get_if<Slope>(&geometry.shape)) return slope->cells_over;
  if (const auto* profile = std::get_if<GroundProfile>(&geometry.shape)) return profile->cells_over;
  const auto* box = std::get_if<Box>(&geometry.shape);
  return box ? box->cells.back() : 0;
}

double own_cells(const Geometry& geometry) {
  double along = 1;
  if (const auto* slope = std::get_if<Slope>(&geometry.shape)) along = slope->cells_along;
  if (const auto* profile = std::get_if<GroundProfile>(&geometry.shape)) along = profile->cells_along;
  if (const auto* box = std::get_if<Box>(&geometry.shape))
    for (int axis = 0; axis + 1 < box->dim(); ++axis) along *= box->cells[axis];
  return along * own_cells_over(geometry);
}

int along_factor(const Geometry& geometry, int cells) {
  return std::max(1, cells / own_cells_over(geometry));
}

/// Halvings of a mesh's own cells until there are at least `cells`.
int halvings_to(const meshes::Mesh& mesh, int cells) {
  int halvings = 0;
  for (double count = mesh.cell_count(); count < cells; count *= 1 << mesh.dim) ++halvings;
  return halvings;
}

/// The shape with its vertical extent times `factor`: the background grid of a surface inside cells.
Shape stretched(const Shape& shape, double factor) {
  Shape out = shape;
  if (auto* column = std::get_if<Column>(&out)) column->height *= factor;
  if (auto* slope = std::get_if<Slope>(&out)) slope->thickness *= factor;
  if (auto* box = std::get_if<Box>(&out)) box->size.back() *= factor;
  if (auto* profile = std::get_if<GroundProfile>(&out)) {
    Polyline& surface = profile->surface;
    for (std::size_t i = 0; i < surface.x.size(); ++i) {
      const double base = profile->bedrock.at(surface.x[i]);
      surface.y[i] = base + factor * (surface.y[i] - base);
    }
  }
  return out;
}

meshes::Mesh with_soils(const Scene& scene, meshes::Mesh mesh) {
  lay_soils(scene, mesh);
  return mesh;
}

}  // namespace

double room(const Scene& scene) {
  const auto* profile = std::get_if<GroundProfile>(&scene.geometry.shape);
  return profile != nullptr ? profile->room : 0;
}

int own_cells_over(const Scene& scene) {
  return own_cells_over(scene.geometry);
}

meshes::Mesh mpm_mesh(const Scene& scene) {
  const Geometry& geometry = scene.geometry;
  if (std::holds_alternative<MeshFile>(geometry.shape))
    return with_soils(scene, user_mesh(scene, std::get<MeshFile>(geometry.shape)));
  const int cells = own_cells_over(geometry);
  if (!(scene.mpm.surface_in_cell < 1)) return with_soils(scene, block_mesh(geometry, {cells, 1, 0, room(scene)}));
  Geometry grid = geometry;
  grid.shape = stretched(geometry.shape, cells / (cells - 1 + scene.mpm.surface_in_cell));
  return with_soils(scene, block_mesh(grid, {cells}));
}

std::vector<meshes::Point> surface_inside_cells(const Scene& scene) {
  std::vector<meshes::Point> line;
  if (const Box* box = std::get_if<Box>(&scene.geometry.shape))
    for (std::size_t i = 0; i < box->surface.x.size(); ++i) line.push_back({box->surface.x[i], box->surface.y[i], 0});
  if (!(scene.mpm.surface_in_cell < 1) && !(room(scene) > 0)) return line;
  for (const double x : stations(scene.geometry)) line.push_back({x, surface_at(scene.geometry, x), 0});
  return line;
}

bool can_coarsen(const Scene& scene, int cells) {
  const Geometry& geometry = scene.geometry;
  if (std::holds_alternative<Column>(geometry.shape)) return can_coarsen(geometry, cells, 1);
  if (geometry.dim() != 0) return can_coarsen(geometry, cells, along_factor(geometry, cells));
  return halvings_to(user_mesh(scene, std::get<MeshFile>(geometry.shape)), cells) > 0;
}

meshes::Mesh reference_mesh(const Scene& scene, int cells, int halvings) {
  const Geometry& geometry = scene.geometry;
  if (std::holds_alternative<Column>(geometry.shape)) return with_soils(scene, line_mesh(geometry, cells, halvings));
  if (geometry.dim() != 0) {
    const int own = own_cells_over(geometry), factor = along_factor(geometry, cells), dim = geometry.dim();
    require_affordable(scene, own_cells(geometry) / own * cells * std::pow(factor, dim - 1) * std::exp2(dim * halvings),
                       std::to_string(own) + ", the shape's own from base to surface");
    return with_soils(scene, block_mesh(geometry, {cells, factor, halvings}));
  }
  meshes::Mesh mesh = user_mesh(scene, std::get<MeshFile>(scene.geometry.shape));
  const int total = halvings_to(mesh, cells) + halvings;
  require_affordable(scene, mesh.cell_count() * std::exp2(mesh.dim * total), "the mesh's own number");
  for (int i = 0; i < total; ++i) mesh = meshes::refined(mesh);
  meshes::renumber_by_position(mesh);
  lay_soils(scene, mesh);
  return mesh;
}

}  // namespace wetfront::verification
