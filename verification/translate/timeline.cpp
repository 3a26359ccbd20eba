#include "verification/translate/timeline.h"

#include "verification/scene/filling_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace wetfront::verification {
namespace {

/// Projected on the ground: by length in two dimensions, by the shoelace rule in three.
double horizontal_area(const meshes::Mesh& mesh, const meshes::Side& side) {
  if (mesh.dim == 1) return 1;  // volumes are per area already
  const int corners = meshes::nodes_per_face(mesh.dim);
  double area = 0;
  for (std::size_t f = 0; f < side.faces.size(); f += corners) {
    double twice = 0;
    for (int i = 0; i < corners; ++i) {
      const meshes::Point &a = mesh.nodes[side.faces[f + i]], &b = mesh.nodes[side.faces[f + (i + 1) % corners]];
      twice += mesh.dim == 2 ? (i == 0 ? 2 * (b[0] - a[0]) : 0) : a[0] * b[1] - b[0] * a[1];
    }
    area += std::abs(twice) / 2;
  }
  return area;
}

double seconds(const SceneTime& time, const FillingTime& filling) {
  const auto value = seconds_of(time, filling);
  if (value) return *value;
  throw std::runtime_error(time.origin.text() + ": a time 'of filling' is used where nothing fills (" +
                           filling.why_not + "). Write it in seconds");
}

}  // namespace

Timeline timeline(const Scene& scene) {
  const FillingTime filling = filling_time(scene);
  Timeline line;
  line.filling_time = filling.seconds;
  for (const Stage& stage : scene.stages) line.stage_end.push_back(seconds(stage.until, filling));
  for (const SceneTime& time : scene.comparison.times) line.comparison_times.push_back(seconds(time, filling));
  for (const Tolerance& tolerance : scene.comparison.tolerances)
    line.tolerance_times.push_back(tolerance.at ? seconds(*tolerance.at, filling)
                                                : std::numeric_limits<double>::quiet_NaN());
  return line;
}

double rain_area(const Scene& scene, const meshes::Mesh& mesh) {
  double area = 0;
  for (const Rain& rain : scene.rains) area += horizontal_area(mesh, mesh.side(rain.side));
  return area;
}

double ledger_area(const Scene& scene, const meshes::Mesh& mesh) {
  if (!scene.rains.empty()) return rain_area(scene, mesh);
  if (mesh.dim == 1) return 1;
  double area = 1;
  for (int axis = 0; axis + 1 < mesh.dim; ++axis) {
    const auto [first, last] = std::ranges::minmax_element(
        mesh.nodes, [axis](const meshes::Point& a, const meshes::Point& b) { return a[axis] < b[axis]; });
    area *= (*last)[axis] - (*first)[axis];
  }
  return area;
}

double rain_asked(const Scene& scene, const meshes::Mesh& mesh, double time) {
  double volume = 0;
  for (const Rain& rain : scene.rains)
    volume += meshes::depth_until(rain.record, time) * horizontal_area(mesh, mesh.side(rain.side));
  return volume;
}

std::string describe(const SceneTime& time, double seconds) {
  if (!time.of_filling) return fmt::format("{:.6g} s", seconds);
  return fmt::format("{:.4g} % of filling ({:.5g} s)", 100 * time.value, seconds);
}

}  // namespace wetfront::verification
