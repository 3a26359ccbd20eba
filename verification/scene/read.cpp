#include "verification/scene/read.h"

#include "verification/scene/reading.h"

#include <cmath>
#include <fstream>
#include <sstream>

namespace wetfront::verification {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const Complaint& complaint) {
  Complaints complaints(path.string());
  complaints.add({1, 1}, complaint);
  throw SceneError(complaints.in_order());
}

}  // namespace

std::string scene_file_text(const std::filesystem::path& path, const std::vector<Setting>& settings) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    refuse(path, {"this is a folder", "a scene is a file", "Name the .toml file in it."});
  std::ifstream file(path, std::ios::binary);
  if (!file)
    refuse(path, {"the scene cannot be read",
                  std::filesystem::exists(path, error) ? "permission denied" : "there is no such file",
                  "Check the path, or start one with `wetfront new NAME`."});
  std::ostringstream content;
  content << file.rdbuf();
  std::string text = content.str();
  for (const Setting& setting : settings) text = with_value(text, path.string(), setting);
  return text;
}

bool Reading::elastic() const {
  for (const Soil& soil : scene.soils)
    if (soil.elastic) return true;
  return false;
}

FillingTime Reading::filling() const {
  return wet() && !scene.water ? FillingTime{} : filling_time(scene);
}

double Reading::unit_weight() const {
  const auto& g = scene.gravity;
  return scene.water ? scene.water->density * std::hypot(g[0], g[1], g[2]) : 0;
}

std::vector<SectionReader> Reading::sections(const std::string& name) const {
  std::vector<SectionReader> found = sections_of(root, name, complaints);
  for (SectionReader& reader : found) reader.weigh_water(unit_weight());
  return found;
}

std::optional<SectionReader> Reading::section(const std::string& name) const {
  std::vector<SectionReader> found = sections(name);
  return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
}

void check_plane(SectionReader& reader, const std::string& name, const std::vector<double>& components,
                 const Geometry& geometry) {
  if (components.size() == 3 && geometry.dim() == 2)
    reader.complain(name, {reader.shown(name) + " has a third component", "this ground lies in the plane x, y",
                           "Give x and y only."});
  if (components.size() == 2 && geometry.dim() == 3 && reader.has(name))
    reader.complain(
        name, {reader.shown(name) + " has no third component", "this ground lies in space, z up", "Give x, y and z."});
}

void read_top(Reading& reading) {
  SectionReader top(reading.root, "", {1, 1}, reading.complaints);
  reading.scene.title = top.text("title");
  reading.scene.requirement = top.text("requirement");
  const std::vector<double> gravity = top.vector("gravity");
  if (!gravity.empty()) reading.scene.gravity = {0, 0, 0};
  for (std::size_t i = 0; i < gravity.size(); ++i) reading.scene.gravity[i] = gravity[i];
  reading.scene.gravity_origin = top.origin_of("gravity");
  check_plane(top, "gravity", gravity, reading.scene.geometry);
  const Geometry& geometry = reading.scene.geometry;
  const bool column = std::holds_alternative<Column>(geometry.shape);
  const bool space = geometry.dim() == 3;
  if (space && !top.has("gravity")) reading.scene.gravity = {0, 0, -9.81};
  auto& g = reading.scene.gravity;
  const double up = g[space ? 2 : 1];
  if (geometry.dim() != 0 && ((column && std::abs(g[0]) > 0) || up > 0)) {
    g = {0, space ? 0 : -std::abs(up), space ? -std::abs(up) : 0};
    top.complain("gravity",
                 {"gravity does not pull down", column ? "a column is vertical, and up is positive" : "up is positive",
                  "Write gravity = [\"0 m/s2\", \"-9.81 m/s2\"], or use a slope."});
  }
  top.finish();
}

Scene read_scene(const std::filesystem::path& path, const std::vector<Setting>& settings) {
  Scene scene;
  scene.path = path;
  scene.text = scene_file_text(path, settings);
  const Value root = parse_document(scene.text, path.string());
  if (root.entries.empty())
    refuse(path,
           {"the scene is empty", "nothing says what is there", "`wetfront new NAME` writes a scene to start from."});
  Complaints complaints(path.string());
  Reading reading{root, complaints, scene};
  for (const auto part : {read_geometry, read_top, read_soils, read_initial, read_rains, read_evaporation,
                          read_boundaries, read_probes, read_riders, read_skeleton, read_stages, read_comparison})
    part(reading);
  if (complaints.any()) throw SceneError(complaints.in_order());
  return scene;
}

}  // namespace wetfront::verification
