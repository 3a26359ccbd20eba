#include "verification/present/field_files.h"

#include <map>

namespace wetfront::verification {
namespace {

std::vector<double> flattened(const std::vector<meshes::Point>& points) {
  std::vector<double> flat;
  for (const auto& point : points) flat.insert(flat.end(), point.begin(), point.end());
  return flat;
}

reports::FieldFile file_at(const meshes::FieldHistory& history, const meshes::Snapshot& snapshot,
                           const std::string& stem, const std::vector<meshes::Point>& places) {
  reports::FieldFile file;
  file.stem = stem;
  file.time = snapshot.time;
  file.dim = history.mesh.dim;
  file.nodes = flattened(places);
  return file;
}

reports::FieldFile grid_file(const meshes::FieldHistory& history, const meshes::Snapshot& snapshot,
                             const std::string& stem) {
  reports::FieldFile file = file_at(history, snapshot, stem + "_grid", history.mesh.nodes);
  file.cells = history.mesh.cells;
  const auto add = [&](const char* name, bool per_cell, int components, const std::vector<double>& values) {
    if (!values.empty()) file.fields.push_back({name, per_cell, components, values});
  };
  add("pore_pressure [Pa]", false, 1, snapshot.node_pressure);
  add("saturation [-]", false, 1, snapshot.node_saturation);
  add("cell_pore_pressure [Pa]", true, 1, snapshot.cell_pressure);
  add("cell_saturation [-]", true, 1, snapshot.cell_saturation);
  add("displacement [m]", false, 3, flattened(snapshot.node_displacement));
  return file;
}

reports::FieldFile points_file(const meshes::FieldHistory& history, const meshes::Snapshot& snapshot,
                               const std::string& stem) {
  reports::FieldFile file = file_at(history, snapshot, stem + "_points", snapshot.points.position);
  const auto add = [&](const char* name, const std::vector<double>& values) {
    if (!values.empty()) file.fields.push_back({name, false, 1, values});
  };
  add("pore_pressure [Pa]", snapshot.points.pressure);
  add("saturation [-]", snapshot.points.saturation);
  return file;
}

}  // namespace

std::vector<reports::FieldFile> field_files(const meshes::FieldHistory& history, const std::string& stem,
                                            const mpm::BodyRecord& body) {
  std::vector<reports::FieldFile> files;
  for (const auto& snapshot : history.snapshots) files.push_back(grid_file(history, snapshot, stem));
  std::map<double, reports::FieldFile> points;  // ParaView knows a moment by its time
  for (const auto& snapshot : history.snapshots)
    if (!snapshot.points.position.empty()) points[snapshot.time] = points_file(history, snapshot, stem);
  for (const mpm::Picture& picture : body.pictures) {
    if (picture.snapshot.points.position.empty()) continue;
    reports::FieldFile& file = points[picture.snapshot.time] = points_file(history, picture.snapshot, stem);
    if (!picture.displacement.empty())
      file.fields.push_back({"displacement [m]", false, 3, flattened(picture.displacement)});
  }
  for (auto& [time, file] : points) files.push_back(std::move(file));
  return files;
}

}  // namespace wetfront::verification
