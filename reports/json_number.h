#pragma once

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

/// Numbers in result.json: those that JSON lacks are the strings "NaN", "Infinity", "-Infinity".
namespace wetfront::reports {

inline nlohmann::ordered_json number_json(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value < 0 ? "-Infinity" : "Infinity";
  return value;
}

inline double number_from(const nlohmann::ordered_json& json) {
  if (json.is_number()) return json.get<double>();
  const auto text = json.get<std::string>();
  if (text == "NaN") return std::numeric_limits<double>::quiet_NaN();
  if (text == "Infinity") return std::numeric_limits<double>::infinity();
  if (text == "-Infinity") return -std::numeric_limits<double>::infinity();
  throw std::runtime_error("'" + text + "' is not a number");
}

inline nlohmann::ordered_json numbers_json(const std::vector<double>& values) {
  auto array = nlohmann::ordered_json::array();
  for (const double value : values) array.push_back(number_json(value));
  return array;
}

inline std::vector<double> numbers_from(const nlohmann::ordered_json& json) {
  std::vector<double> values;
  for (const auto& value : json) values.push_back(number_from(value));
  return values;
}

}  // namespace wetfront::reports
