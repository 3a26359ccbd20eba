#include "verification/scene/setting.h"

#include "verification/scene/complaints.h"
#include "verification/scene/read.h"

#include <algorithm>
#include <charconv>

namespace wetfront::verification {

NumberAndUnit number_and_unit(const std::string& value) {
  double number = 0;
  const char* begin = value.data() + (value.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, value.data() + value.size(), number);
  if (error != std::errc{}) return {};
  std::string unit(end, static_cast<const char*>(value.data() + value.size()));
  unit.erase(0, std::min(unit.find_first_not_of(' '), unit.size()));
  return {std::string(value.data(), end), unit};
}

std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : text) {
    depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    if (c == ',' && depth == 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

Setting read_setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw SceneError({"--set " + text + ": " +
                      Complaint{"this sets nothing", "a path, an equals sign and a value are meant",
                                "Write e.g. --set rain.intensity=2e-5."}
                          .text()});
  return {text.substr(0, equals), text.substr(equals + 1)};
}

std::vector<Setting> read_settings(const std::vector<std::string>& texts) {
  std::vector<Setting> settings;
  for (const std::string& text : texts) settings.push_back(read_setting(text));
  return settings;
}

}  // namespace wetfront::verification
