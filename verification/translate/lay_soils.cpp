#include "verification/translate/lay_soils.h"

#include <algorithm>
#include <stdexcept>

namespace wetfront::verification {
namespace {

void name_regions(const Scene& scene, meshes::Mesh& mesh) {
  const std::vector<std::string> before = mesh.region_names;
  mesh.region_names.clear();
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    std::string name = soil_at(scene, scene_point(mesh.cell_centre(c), mesh.dim), mesh.dim);
    if (name.empty()) name = before[mesh.region[c]];
    auto found = std::find(mesh.region_names.begin(), mesh.region_names.end(), name);
    if (found == mesh.region_names.end()) found = mesh.region_names.insert(found, name);
    mesh.region[c] = static_cast<int>(found - mesh.region_names.begin());
  }
}

void cut_out(const SidePart& part, meshes::Mesh& mesh) {
  const auto of = std::find_if(mesh.sides.begin(), mesh.sides.end(),
                               [&](const meshes::Side& side) { return side.name == part.of; });
  if (of == mesh.sides.end())
    throw std::runtime_error(part.origin.text() + ": the mesh has no side '" + part.of + "'. Name one that it has");
  meshes::Side left{part.of, {}}, cut{part.name, {}};
  const int corners = meshes::nodes_per_face(mesh.dim);
  for (std::size_t f = 0; f < of->faces.size(); f += corners) {
    std::array<double, 3> centre{};
    for (int i = 0; i < corners; ++i)
      for (int axis = 0; axis < 3; ++axis) centre[axis] += mesh.nodes[of->faces[f + i]][axis] / corners;
    std::vector<int>& taken = (part.extent.contains(centre) ? cut : left).faces;
    taken.insert(taken.end(), of->faces.begin() + f, of->faces.begin() + f + corners);
  }
  if (cut.faces.empty())
    throw std::runtime_error(part.origin.text() + ": the part '" + part.name + "' holds nothing of '" + part.of +
                             "' (no face of the mesh has its centre there). Widen it, or refine the mesh");
  *of = left;
  mesh.sides.push_back(cut);
}

}  // namespace

std::string soil_at(const Scene& scene, const std::array<double, 3>& place, int dim) {
  const Geometry& geometry = scene.geometry;
  for (auto zone = geometry.zones.rbegin(); zone != geometry.zones.rend(); ++zone)
    if (zone->extent.contains(place)) return zone->soil;
  if (geometry.layers.empty()) return geometry.dim() == 0 ? "" : scene.soils.front().name;
  const double elevation = place[dim == 3 ? 2 : 1];
  const std::vector<double> bottoms = layer_bottoms(geometry, place[0]);
  for (std::size_t i = 0; i < bottoms.size(); ++i)
    if (elevation > bottoms[i]) return geometry.layers[i].soil;
  return geometry.layers.back().soil;
}

std::array<double, 3> scene_point(const meshes::Point& point, int dim) {
  return dim == 1 ? std::array<double, 3>{0, point[0], 0} : point;
}

void lay_soils(const Scene& scene, meshes::Mesh& mesh) {
  if (!scene.geometry.layers.empty() || !scene.geometry.zones.empty()) name_regions(scene, mesh);
  for (const SidePart& part : scene.geometry.parts) cut_out(part, mesh);
}

std::vector<const Soil*> soils_by_region(const Scene& scene, const meshes::Mesh& mesh) {
  std::vector<const Soil*> soils;
  for (const std::string& region : mesh.region_names) {
    const auto named =
        std::find_if(scene.soils.begin(), scene.soils.end(), [&](const Soil& soil) { return soil.name == region; });
    if (named == scene.soils.end() && scene.soils.size() != 1)
      throw std::runtime_error("the mesh region '" + region + "' has no soil of that name in the scene");
    soils.push_back(named == scene.soils.end() ? &scene.soils.front() : &*named);
  }
  return soils;
}

std::vector<double> conductivity_factors(const Scene& scene, const meshes::Mesh& mesh) {
  const std::vector<const Soil*> soils = soils_by_region(scene, mesh);
  if (std::ranges::none_of(soils, [](const Soil* soil) { return soil->conductivity_field.has_value(); })) return {};
  std::vector<double> factors;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const auto& field = soils[mesh.region[c]]->conductivity_field;
    factors.push_back(field ? field->at(scene_point(mesh.cell_centre(c), mesh.dim)) : 1);
  }
  return factors;
}

}  // namespace wetfront::verification
