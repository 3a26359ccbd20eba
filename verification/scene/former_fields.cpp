#include "verification/scene/former_fields.h"

#include <charconv>
#include <fstream>

namespace wetfront::verification {
namespace {

/// `value` of `name="value"` in a line; "" when it is not there.
std::string attribute(const std::string& line, const std::string& name) {
  const auto at = line.find(' ' + name + "=\"");
  if (at == std::string::npos) return "";
  const auto from = at + name.size() + 3, to = line.find('"', from);
  return to == std::string::npos ? "" : line.substr(from, to - from);
}

}  // namespace

FormerFields former_fields(const std::filesystem::path& collection) {
  FormerFields fields;
  std::ifstream file(collection);
  for (std::string line; std::getline(file, line);) {
    if (line.find("<DataSet") == std::string::npos) continue;
    const std::string time = attribute(line, "timestep"), name = attribute(line, "file");
    double seconds = 0;
    const auto [end, status] = std::from_chars(time.data(), time.data() + time.size(), seconds);
    if (status != std::errc() || name.empty()) continue;
    fields.time.push_back(seconds);
    fields.file.push_back(name);
  }
  return fields;
}

}  // namespace wetfront::verification
