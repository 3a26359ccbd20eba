#include "verification/present/field_pictures.h"

#include "verification/compare/magnitude.h"
#include "verification/compare/profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

using reports::FieldPicture;

constexpr double kPa = 1000;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

struct Painted {
  std::string id, title, quantity, unit_name;
  double unit;
  std::vector<double> meshes::Snapshot::*nodal;
};

const Painted painted[] = {
    {"pressure_field", "Pore pressure", "pore pressure", "kPa", kPa, &meshes::Snapshot::node_pressure},
    {"saturation_field", "Degree of saturation", "degree of saturation", "1", 1, &meshes::Snapshot::node_saturation}};

FieldPicture on_mesh(const meshes::Mesh& mesh, const Painted& field, double time) {
  FieldPicture picture{
      field.id, fmt::format("{} at {:.6g} s", field.title, time), "Fields", field.quantity, field.unit_name, {}, {}, {},
      {}};
  for (const meshes::Point& node : mesh.nodes) {
    picture.x.push_back(node[0]);
    picture.y.push_back(node[1]);
  }
  picture.cells = mesh.cells;
  return picture;
}

FieldPicture::Panel panel(const std::string& label, std::vector<double> nodal, double unit) {
  for (double& value : nodal) value /= unit;
  return {label, std::move(nodal), false};
}

/// Whether the mesh is one row or column of cells, where a picture would be a line: n x m cells have
/// 2 (nm + 1) - (n - 1)(m - 1) nodes.
bool is_strip(const meshes::Mesh& mesh) {
  return mesh.node_count() >= 2 * (mesh.cell_count() + 1);
}

bool paintable(const meshes::FieldHistory& history) {
  return history.mesh.dim == 2 && !history.snapshots.empty() && !is_strip(history.mesh);
}

}  // namespace

std::vector<FieldPicture> field_pictures(const Histories& histories) {
  const meshes::FieldHistory &candidate = histories.candidate, &reference = histories.reference;
  const std::size_t times = std::min(candidate.snapshots.size(), reference.snapshots.size());
  if (times == 0 || !paintable(candidate) || reference.mesh.dim != 2) return {};
  const std::vector<double> compared = node_weights(candidate.mesh, reference.mesh);
  const meshes::Snapshot &last = candidate.snapshots[times - 1], &expected = reference.snapshots[times - 1];
  std::vector<const std::vector<double>*> fields;
  for (const Painted& field : painted) fields.push_back(&(expected.*field.nodal));
  auto expected_here = values_at_nodes(reference.mesh, fields, candidate.mesh);
  std::vector<FieldPicture> pictures;
  for (const Painted& field : painted) {
    FieldPicture picture = on_mesh(candidate.mesh, field, expected.time);
    picture.panels = {panel("MPM", last.*field.nodal, field.unit),
                      panel("reference", std::move(expected_here[pictures.size()]), field.unit),
                      {"MPM minus reference", {}, true}};
    std::vector<double>&mpm = picture.panels[0].nodal, &other = picture.panels[1].nodal;
    for (std::size_t i = 0; i < compared.size(); ++i) {
      if (compared[i] == 0) mpm[i] = other[i] = nothing;
      picture.panels[2].nodal.push_back(mpm[i] - other[i]);
    }
    pictures.push_back(std::move(picture));
  }
  for (FieldPicture& moved : displacement_picture(candidate, "MPM")) pictures.push_back(std::move(moved));
  return pictures;
}

std::vector<FieldPicture> field_pictures(const meshes::FieldHistory& history, const std::string& who) {
  if (!paintable(history)) return {};
  std::vector<FieldPicture> pictures;
  for (const Painted& field : painted) {
    if ((history.snapshots.back().*field.nodal).empty()) continue;
    pictures.push_back(on_mesh(history.mesh, field, history.snapshots.back().time));
    pictures.back().panels = {panel(who, history.snapshots.back().*field.nodal, field.unit)};
  }
  for (FieldPicture& moved : displacement_picture(history, who)) pictures.push_back(std::move(moved));
  return pictures;
}

std::vector<FieldPicture> displacement_picture(const meshes::FieldHistory& history, const std::string& who) {
  if (!paintable(history)) return {};
  const meshes::Snapshot& last = history.snapshots.back();
  if (last.node_displacement.size() != history.mesh.node_count()) return {};
  std::vector<double> moved;
  for (const meshes::Point& d : last.node_displacement) moved.push_back(std::hypot(d[0], d[1]));
  if (std::ranges::max(moved) == 0) return {};
  const Painted field{"displacement_field", "Displacement", "displacement", "m", 1, nullptr};
  FieldPicture picture = on_mesh(history.mesh, field, last.time);
  picture.panels = {panel(who, std::move(moved), 1)};
  return {picture};
}

double pressure_per_head(const Scene& scene) {
  return scene.water ? scene.water->density * magnitude(scene.gravity) / kPa : 0;
}

}  // namespace wetfront::verification
