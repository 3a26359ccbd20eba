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

std::string contents(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    refuse(path, {"this is a folder", "a scene is a file", "Name the .toml file in it."});
  std::ifstream file(path, std::ios::binary);
  if (!file)
    refuse(path, {"the scene cannot be read",
                  std::filesystem::exists(path, error) ? "permission denied" : "there is no such file",
                  "Check the path, or start one with `wetfront new NAME`."});
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

bool Reading::elastic() const {
  for (const Soil& soil : scene.soils)
    if (soil.elastic) return true;
  return false;
}

FillingTime Reading::filling() const {
  return wet() && !scene.water ? FillingTime{} : filling_time(scene);
}

std::vector<std::string> Reading::sides() const {
  if (std::holds_alternative<MeshFile>(scene.geometry.shape)) return {};
  return {"top", "base", "left", "right"};
}

void check_plane(SectionReader& reader, const std::string& name, const std::vector<double>& components,
                 const Geometry& geometry) {
  if (components.size() == 3 && !std::holds_alternative<MeshFile>(geometry.shape))
    reader.complain(name, {reader.shown(name) + " has a third component", "columns and slopes lie in the plane x, y",
                           "Give x and y only."});
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
  const bool column = std::holds_alternative<Column>(reading.scene.geometry.shape);
  const bool mesh = std::holds_alternative<MeshFile>(reading.scene.geometry.shape);
  if (gravity.size() > 1 && ((column && std::abs(gravity[0]) > 0) || (!mesh && gravity[1] > 0))) {
    reading.scene.gravity = {0, -std::abs(gravity[1]), 0};
    top.complain("gravity",
                 {"gravity does not pull down", column ? "a column is vertical, and up is positive" : "up is positive",
                  "Write gravity = [\"0 m/s2\", \"-9.81 m/s2\"], or use a slope."});
  }
  top.finish();
}

Scene read_scene(const std::filesystem::path& path) {
  Scene scene;
  scene.path = path;
  scene.text = contents(path);
  const Value root = parse_document(scene.text, path.string());
  if (root.entries.empty())
    refuse(path,
           {"the scene is empty", "nothing says what is there", "`wetfront new NAME` writes a scene to start from."});
  Complaints complaints(path.string());
  Reading reading{root, complaints, scene};
  for (const auto part : {read_geometry, read_top, read_soils, read_initial, read_rains, read_boundaries, read_probes,
                          read_stages, read_comparison})
    part(reading);
  if (complaints.any()) throw SceneError(complaints.in_order());
  return scene;
}

}  // namespace wetfront::verification
