#include "tests/reports/json_schema.h"

#include <algorithm>
#include <regex>
#include <set>
#include <stdexcept>

namespace wetfront::reports::testing {

namespace {

using Json = nlohmann::json;

class Check {
 public:
  explicit Check(const Json& root) : root_(root) {}

  void walk(const Json& schema, const Json& value, const std::string& path) {
    if (schema.contains("$ref")) walk(resolve(schema["$ref"].get<std::string>()), value, path);
    static const std::set<std::string> known = {
        "$ref", "$schema", "$defs",      "title",    "description",          "type",  "const",
        "enum", "pattern", "properties", "required", "additionalProperties", "items", "anyOf"};
    for (const auto& [keyword, argument] : schema.items())
      if (!known.count(keyword)) throw std::logic_error("schema keyword " + keyword);
    if (schema.contains("type") && !is(value, schema["type"].get<std::string>()))
      return report(path, "is no " + schema["type"].get<std::string>());
    if (schema.contains("const") && value != schema["const"]) report(path, "is not " + schema["const"].dump());
    if (schema.contains("enum") && std::count(schema["enum"].begin(), schema["enum"].end(), value) == 0)
      report(path, "is none of " + schema["enum"].dump());
    if (schema.contains("pattern") &&
        !std::regex_search(value.get<std::string>(), std::regex(schema["pattern"].get<std::string>())))
      report(path, "does not match " + schema["pattern"].dump());
    if (schema.contains("anyOf")) any_of(schema["anyOf"], value, path);
    if (schema.contains("properties")) members(schema, value, path);
    if (schema.contains("items"))
      for (std::size_t i = 0; i < value.size(); ++i) walk(schema["items"], value[i], path + "/" + std::to_string(i));
  }

  std::vector<std::string> found;

 private:
  const Json& resolve(const std::string& reference) const { return root_.at(Json::json_pointer(reference.substr(1))); }

  void report(const std::string& path, const std::string& problem) { found.push_back(path + " " + problem); }

  static bool is(const Json& value, const std::string& type) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "integer") return value.is_number_integer();
    if (type == "number") return value.is_number();
    throw std::logic_error("schema type " + type);
  }

  void any_of(const Json& choices, const Json& value, const std::string& path) {
    for (const Json& choice : choices) {
      Check trial(root_);
      trial.walk(choice, value, path);
      if (trial.found.empty()) return;
    }
    report(path, "fits none of the choices");
  }

  void members(const Json& schema, const Json& value, const std::string& path) {
    for (const Json& key : schema["required"])
      if (!value.contains(key)) report(path, "lacks " + key.get<std::string>());
    for (const auto& [key, member] : value.items()) {
      if (schema["properties"].contains(key))
        walk(schema["properties"][key], member, path + "/" + key);
      else if (schema.contains("additionalProperties"))
        walk(schema["additionalProperties"], member, path + "/" + key);
      else
        report(path, "has an undocumented member " + key);
    }
  }

  const Json& root_;
};

}  // namespace

std::vector<std::string> violations(const nlohmann::json& schema, const nlohmann::json& value) {
  Check check(schema);
  check.walk(schema, value, "");
  return check.found;
}

}  // namespace wetfront::reports::testing
