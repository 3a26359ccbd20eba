#include "verification/translate/initial_pressure.h"

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

/// Height above the origin, against gravity [m].
double elevation(const Scene& scene, const meshes::Point& point, int dim) {
  if (dim == 1) return point[0];
  const double g = gravity_magnitude(scene);
  double height = 0;
  for (int axis = 0; axis < 3; ++axis) height -= scene.gravity[axis] / g * point[axis];
  return height;
}

}  // namespace

double gravity_magnitude(const Scene& scene) {
  return std::hypot(scene.gravity[0], scene.gravity[1], scene.gravity[2]);
}

double initial_pressure(const Scene& scene, const meshes::Point& point, int dim) {
  if (const auto* uniform = std::get_if<UniformStart>(&scene.initial->pressure)) return uniform->pressure;
  const auto& start = std::get<HydrostaticStart>(scene.initial->pressure);
  const double unit_weight = scene.water->density * gravity_magnitude(scene);
  return std::max(unit_weight * (start.water_table - elevation(scene, point, dim)), -start.suction_cap);
}

std::vector<double> initial_pressure(const Scene& scene, const meshes::Mesh& mesh) {
  std::vector<double> pressure;
  pressure.reserve(mesh.node_count());
  for (const meshes::Point& node : mesh.nodes) pressure.push_back(initial_pressure(scene, node, mesh.dim));
  return pressure;
}

}  // namespace wetfront::verification
