#include "verification/translate/initial_pressure.h"

#include "verification/translate/antecedent.h"
#include "verification/translate/former_field.h"
#include "verification/translate/lay_soils.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace wetfront::verification {
namespace {

using Pressures = std::vector<double>;

template <class At>
Pressures at_nodes(const meshes::Mesh& mesh, At at) {
  Pressures pressure;
  pressure.reserve(mesh.node_count());
  for (const meshes::Point& node : mesh.nodes) pressure.push_back(at(node));
  return pressure;
}

/// The soils that meet at a node count alike.
Pressures pressure_by_soil(const Scene& scene, const SoilStart& start, const meshes::Mesh& mesh) {
  std::vector<std::set<std::string>> soils(mesh.node_count());
  const std::vector<const Soil*> of_region = soils_by_region(scene, mesh);
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    for (const int node : mesh.cell(c)) soils[node].insert(of_region[mesh.region[c]]->name);
  Pressures pressure;
  for (const auto& names : soils) {
    double sum = 0;
    for (const auto& [name, value] : start.pressure)
      if (names.count(name)) sum += value;
    pressure.push_back(sum / static_cast<double>(names.size()));
  }
  return pressure;
}

}  // namespace

double elevation(const Scene& scene, const meshes::Point& point, int dim) {
  if (dim == 1) return point[0];
  const double g = gravity_magnitude(scene);
  double height = 0;
  for (int axis = 0; axis < 3; ++axis) height -= scene.gravity[axis] / g * point[axis];
  return height;
}

double gravity_magnitude(const Scene& scene) {
  return std::hypot(scene.gravity[0], scene.gravity[1], scene.gravity[2]);
}

bool start_is_computed(const Scene& scene) {
  return scene.initial && (std::holds_alternative<SteadyStart>(scene.initial->pressure) ||
                           std::holds_alternative<SpinUpStart>(scene.initial->pressure));
}

Pressures hydrostatic_pressure(const Scene& scene, const HydrostaticStart& start, const meshes::Mesh& mesh) {
  const double unit_weight = scene.water->density * gravity_magnitude(scene);
  return at_nodes(mesh, [&](const meshes::Point& node) {
    const double table = !start.line.x.empty()
                             ? start.line.at(node[0])
                             : start.water_table + (start.over_base ? base_at(scene.geometry, node[0]) : 0);
    return std::max(unit_weight * (table - elevation(scene, node, mesh.dim)), -start.suction_cap);
  });
}

Pressures initial_pressure(const Scene& scene, const meshes::Mesh& mesh) {
  if (start_is_computed(scene)) return antecedent_pressure(scene).at_nodes(mesh);
  const auto& pressure = scene.initial->pressure;
  if (const auto* start = std::get_if<UniformStart>(&pressure)) return Pressures(mesh.node_count(), start->pressure);
  if (const auto* start = std::get_if<ProfileStart>(&pressure))
    return at_nodes(mesh, [&](const meshes::Point& node) {
      return interpolate(start->elevation, start->pressure, elevation(scene, node, mesh.dim));
    });
  if (const auto* start = std::get_if<SoilStart>(&pressure)) return pressure_by_soil(scene, *start, mesh);
  if (const auto* start = std::get_if<FieldStart>(&pressure)) {
    if (!start->file.empty()) return read_former_field(start->file).at_nodes(mesh);
    return at_nodes(mesh, [&](const meshes::Point& node) { return start->pressure.at(scene_point(node, mesh.dim)); });
  }
  return hydrostatic_pressure(scene, std::get<HydrostaticStart>(pressure), mesh);
}

}  // namespace wetfront::verification
