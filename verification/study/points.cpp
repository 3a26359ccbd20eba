#include "verification/study/points.h"

#include "reports/whole_file.h"
#include "verification/run/content_hash.h"
#include "verification/run/version.h"
#include "verification/scene/document.h"
#include "verification/scene/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace wetfront::verification {
namespace {

/// Contents of every file that a text in the document names, relative to the scene's folder.
void add_files(const Value& value, const std::filesystem::path& folder, ContentHash& hash) {
  std::error_code error;
  if (value.kind == Value::Kind::text && !value.text.empty() && value.text.size() < 4096 &&
      std::filesystem::is_regular_file(folder / value.text, error)) {
    hash.add(std::string_view(reports::read_whole(folder / value.text)));
  }
  for (const Value& item : value.items) add_files(item, folder, hash);
  for (const Entry& entry : value.entries) add_files(entry.value, folder, hash);
}

}  // namespace

Variation read_variation(const std::string& text) {
  const Setting setting = read_setting(text);
  Variation variation{setting.path, split_at_commas(setting.value)};
  auto sorted = variation.values;
  std::ranges::sort(sorted);
  if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
    throw SceneError(
        {fmt::format("--set {}: the value '{}' stands there twice (the same point would be computed "
                     "twice). Leave one out.",
                     setting.path, *twice)});
  return variation;
}

std::vector<StudyPoint> product(const std::vector<Variation>& variations) {
  for (std::size_t i = 0; i < variations.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (variations[i].path == variations[j].path)
        throw SceneError(
            {fmt::format("--set {}: this is given twice (only one could count). Write all its values "
                         "behind one equals sign, with commas.",
                         variations[i].path)});
  std::vector<StudyPoint> points(1);
  for (const Variation& variation : variations) {
    std::vector<StudyPoint> more;
    for (const StudyPoint& point : points)
      for (const std::string& value : variation.values) {
        StudyPoint next = point;
        next.name += (next.name.empty() ? "" : ", ") + variation.path + "=" + value;
        next.settings.push_back({variation.path, value});
        more.push_back(std::move(next));
      }
    points = std::move(more);
  }
  return points;
}

std::string point_hash(const std::filesystem::path& scene, const StudyPoint& point) {
  const std::string text = scene_file_text(scene, point.settings);
  ContentHash hash;
  hash.add(std::string_view(text));
  add_files(parse_document(text, scene.string()), scene.parent_path(), hash);
  hash.add(std::string_view(version::number));
  hash.add(std::string_view(version::git_hash));
  return hash.text();
}

std::filesystem::path point_folder(const std::filesystem::path& out, std::size_t index, const StudyPoint& point) {
  std::string name = fmt::format("{:03}_", index);
  for (const char c : point.name.substr(0, 80))
    name += std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '_' || c == '+' ? c : '-';
  return out / name;
}

}  // namespace wetfront::verification
