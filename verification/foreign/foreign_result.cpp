#include "verification/foreign/foreign_result.h"

#include "verification/compare/profile.h"
#include "verification/foreign/point_data.h"
#include "verification/scene/read.h"
#include "verification/translate/scene_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

/// Means of the points in each cell of a column, told by elevation alone.
std::vector<double> cell_means(const meshes::Mesh& mesh, const PointData& data, const std::vector<double>& values,
                               const ForeignField& field, const std::filesystem::path& file) {
  const int up = meshes::up_axis(mesh.dim);
  std::vector<double> sum(mesh.cell_count(), 0), count(mesh.cell_count(), 0);
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    double low = 1e300, high = -1e300;
    for (const int node : mesh.cell(c))
      low = std::min(low, mesh.nodes[node][up]), high = std::max(high, mesh.nodes[node][up]);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double y = data.position[i][static_cast<std::size_t>(up)];
      if (y >= low && y < high) sum[c] += values[i] * field.factor, ++count[c];
    }
    if (count[c] == 0)
      cannot_read(file.string(), fmt::format("no point lies between the elevations {:g} m and {:g} m", low, high),
                  "a cell without points has no value", "Give the scene larger cells, or check where its ground lies.");
    sum[c] /= count[c];
  }
  return sum;
}

/// The points themselves, in the units of a history. Only their elevation counts: they are put on the column's axis.
meshes::PointCloud cloud_of(const ForeignResult& result, const PointData& data, const meshes::Mesh& mesh,
                            const std::filesystem::path& file) {
  const auto in_our_unit = [&](const ForeignField& field) {
    std::vector<double> values = scalar(data, field.array, file);
    for (double& value : values) value *= field.factor;
    return values;
  };
  meshes::PointCloud cloud{data.position, in_our_unit(result.pressure), in_our_unit(result.saturation)};
  const meshes::Point centre = mesh.cell_centre(0);
  for (meshes::Point& place : cloud.position)
    for (int axis = 0; axis < 3; ++axis)
      if (axis != meshes::up_axis(mesh.dim))
        place[static_cast<std::size_t>(axis)] = centre[static_cast<std::size_t>(axis)];
  return cloud;
}

/// With places in metres.
PointData points_of(const ForeignResult& result, const ForeignSnapshot& snapshot) {
  PointData data = read_points(snapshot.file, result.places);
  for (auto& place : data.position)
    for (double& coordinate : place) coordinate *= result.metres;
  return data;
}

std::vector<double> at_nodes(const meshes::Mesh& mesh, const std::vector<double>& cells) {
  std::vector<double> sum(mesh.node_count(), 0), count(mesh.node_count(), 0);
  for (std::size_t c = 0; c < mesh.cell_count(); ++c)
    for (const int node : mesh.cell(c)) sum[node] += cells[c], ++count[node];
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] /= count[n];
  return sum;
}

}  // namespace

meshes::FieldHistory foreign_history(const ForeignResult& result, const Scene& scene, const Timeline& timeline) {
  if (!std::holds_alternative<Column>(scene.geometry.shape) || scene.soils.size() != 1)
    throw SceneError({scene.geometry.origin.text() +
                      ": another code's result is compared with a column of one soil only (points "
                      "are told by their elevation). Describe the ground as a column."});
  meshes::FieldHistory out;
  out.solver = result.code;
  out.mesh = mpm_mesh(scene);
  out.log.push_back("read from " + result.path.string() + ": values of a cell are the means of the points in it");
  for (const std::string& assumption : result.assumed) out.log.push_back(assumption);
  std::size_t wanted = 0;
  for (const ForeignSnapshot& snapshot : result.snapshots) {
    const PointData data = points_of(result, snapshot);
    meshes::Snapshot kept;
    kept.time = snapshot.time;
    kept.cells_hold_averages = true;
    kept.cell_pressure =
        cell_means(out.mesh, data, scalar(data, result.pressure.array, snapshot.file), result.pressure, snapshot.file);
    kept.cell_saturation = cell_means(out.mesh, data, scalar(data, result.saturation.array, snapshot.file),
                                      result.saturation, snapshot.file);
    kept.points = cloud_of(result, data, out.mesh, snapshot.file);
    kept.node_pressure = at_nodes(out.mesh, kept.cell_pressure);
    kept.node_saturation = at_nodes(out.mesh, kept.cell_saturation);
    double stored = 0;
    for (std::size_t c = 0; c < out.mesh.cell_count(); ++c)
      stored += scene.soils[0].porosity * kept.cell_saturation[c] * out.mesh.cell_measure(c);
    const double asked = rain_asked(scene, out.mesh, snapshot.time);
    const double gained = out.ledger.empty() ? 0 : stored - out.ledger.front().stored;
    out.ledger.push_back({snapshot.time, asked, gained, asked - gained, 0, stored});
    if (wanted < timeline.comparison_times.size() &&
        std::abs(snapshot.time - timeline.comparison_times[wanted]) <= 1e-3 * timeline.comparison_times[wanted]) {
      out.snapshots.push_back(std::move(kept));
      ++wanted;
    }
  }
  if (wanted < timeline.comparison_times.size())
    cannot_read(result.path.string(), fmt::format("no file is declared for {:g} s", timeline.comparison_times[wanted]),
                "[comparison] of the scene asks for that time",
                "Add a [[snapshot]], or compare at a time that there is a file of.");
  return out;
}

std::string looks_wrong(const meshes::FieldHistory& candidate, const meshes::FieldHistory& reference) {
  const auto ours = cell_profiles(candidate), theirs = profiles_at_cells(reference, candidate);
  const auto weight = cell_weights(candidate.mesh, reference.mesh);
  const auto error = [&](double factor) {
    double worst = 0;
    for (std::size_t t = 0; t < std::min(ours.size(), theirs.size()); ++t) {
      std::vector<double> turned = ours[t].pressure;
      for (double& p : turned) p *= factor;
      worst = std::max(worst, relative_l2(turned, theirs[t].pressure, weight));
    }
    return worst;
  };
  const double as_is = error(1);
  for (const auto& [factor, what] : {std::pair{-1.0, "the sign of the pressure looks flipped"},
                                     std::pair{1e3, "the unit of the pressure looks a thousand times too small"},
                                     std::pair{1e-3, "the unit of the pressure looks a thousand times too large"}})
    if (error(factor) < 0.5 * as_is)
      return fmt::format("{}: declared otherwise, its error would be {:.3g} % in place of {:.3g} %", what,
                         100 * error(factor), 100 * as_is);
  return "";
}

}  // namespace wetfront::verification
