#include "verification/scene/complaints.h"
#include "verification/scene/keys.h"
#include "verification/scene/read.h"
#include "verification/scene/units.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace wetfront::verification {
namespace {

using Json = nlohmann::ordered_json;

const char* const with_unit = R"(^\s*[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?\s*(1/)?[^\s0-9,._].*$)";
const char* const number_in_text = R"(^\s*[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?\s*(%|percent)?\s*$)";

Json quantity(const std::string& unit) {
  const Json text = {{"type", "string"}, {"pattern", unit == "1" ? number_in_text : with_unit}};
  return unit == "1" ? Json{{"anyOf", {{{"type", "number"}}, text}}} : text;
}

/// Bounds of a pure number; those of values with units are in the description.
Json quantity(const Key& key) {
  Json schema = quantity(key.unit);
  if (key.unit != "1") return schema;
  Json& number = schema["anyOf"][0];
  if (!key.range.from.empty()) number[key.range.open_from ? "exclusiveMinimum" : "minimum"] = std::stod(key.range.from);
  if (!key.range.to.empty()) number[key.range.open_to ? "exclusiveMaximum" : "maximum"] = std::stod(key.range.to);
  return schema;
}

Json text() {
  return {{"type", "string"}, {"minLength", 1}};
}

/// A list of rows, one quantity per column.
Json rows(const Key& key) {
  Json row = {{"type", "array"}, {"minItems", key.columns.size()}, {"maxItems", key.columns.size()}};
  for (const TableColumn& column : key.columns) row["prefixItems"].push_back(quantity(column.unit));
  return {{"type", "array"}, {"minItems", 1}, {"items", row}};
}

Json section_schema(const std::string& name);

Json value_schema(const Key& key) {
  switch (key.takes) {
    case Takes::text:
    case Takes::path:
      return text();
    case Takes::quantity:
      return quantity(key);
    case Takes::tolerance:
      return {{"type", {"string", "number"}}};
    case Takes::count:
      return {{"type", "integer"}, {"minimum", std::stoi(key.range.from)}, {"maximum", std::stoi(key.range.to)}};
    case Takes::choice:
      return {{"enum", key.choices}};
    case Takes::time:
      return quantity("s");
    case Takes::times:
      return {{"type", "array"}, {"items", quantity("s")}, {"minItems", 1}};
    case Takes::vector:
      return {{"type", "array"}, {"items", quantity(key.unit)}, {"minItems", 2}, {"maxItems", 3}};
    case Takes::series:
      return {
          {"type", "array"},
          {"minItems", 1},
          {"items",
           {{"type", "array"}, {"prefixItems", {quantity("s"), quantity("m/s")}}, {"minItems", 2}, {"maxItems", 2}}}};
    case Takes::record:
    case Takes::level:
      return {{"anyOf", {quantity(key.unit), text(), rows(key)}}};
    case Takes::vectors:
      return {
          {"anyOf",
           {{{"type", "array"}, {"items", quantity(key.unit)}, {"minItems", 2}, {"maxItems", 2}}, text(), rows(key)}}};
    case Takes::pairs:
      return {{"anyOf", {text(), rows(key)}}};
    case Takes::range:
      return {{"type", "array"}, {"items", quantity(key.unit)}, {"minItems", 2}, {"maxItems", 2}};
    case Takes::counts:
      return {{"type", "array"},
              {"minItems", 2},
              {"maxItems", 3},
              {"items",
               {{"type", "integer"}, {"minimum", std::stoi(key.range.from)}, {"maximum", std::stoi(key.range.to)}}}};
    case Takes::pressures:
      return {{"type", "array"},
              {"minItems", 1},
              {"items",
               {{"type", "array"}, {"prefixItems", {text(), quantity(key.unit)}}, {"minItems", 2}, {"maxItems", 2}}}};
    case Takes::table:
      break;
  }
  return section_schema(key.section + "." + key.name);
}

std::string description(const Key& key) {
  std::string text = key.meaning;
  if ((key.takes == Takes::quantity || key.takes == Takes::level) && key.unit != "1")
    text += " (" + dimension(key.unit) + ")";
  if (!key.range.from.empty()) text += "; " + bounds(key.range);
  if (!key.with_key.empty()) text += "; only with " + key.with_key + " = " + alternatives(key.with_choices);
  return text;
}

/// `{if: {with_key is one of with_choices}, then: {required: [name]}, else: {name: false}}`.
Json condition(const Key& key) {
  const bool by_default = std::find(key.with_choices.begin(), key.with_choices.end(),
                                    find_key(key.section, key.with_key)->fallback) != key.with_choices.end();
  Json chosen = {{"properties", {{key.with_key, {{"enum", key.with_choices}}}}}};
  if (!by_default) chosen["required"] = {key.with_key};
  Json rule = {{"if", chosen}, {"else", {{"properties", {{key.name, false}}}}}};
  if (key.presence == Presence::required) rule["then"] = {{"required", {key.name}}};
  return rule;
}

Json section_schema(const std::string& name) {
  const Section& section = section_named(name);
  Json schema = {{"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}};
  if (!section.meaning.empty()) schema["description"] = section.meaning;
  for (const Key* key : keys_of(name)) {
    Json value = value_schema(*key);
    value["description"] = description(*key);
    if (!key->fallback.empty()) value["default"] = key->fallback;
    schema["properties"][key->name] = value;
    if (!key->with_key.empty())
      schema["allOf"].push_back(condition(*key));
    else if (key->presence == Presence::required)
      schema["required"].push_back(key->name);
  }
  for (const std::string& alternative : section.one_of) schema["oneOf"].push_back({{"required", {alternative}}});
  return schema;
}

}  // namespace

std::string scene_schema() {
  Json schema = {
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "wetfront scene"},
      {"$comment", "Generated from verification/scene/keys.cpp. Cross-checks between sections are the reader's."}};
  schema.update(section_schema(""));
  for (const Section& section : sections()) {
    if (section.name.empty() || section.name.find('.') != std::string::npos) continue;
    const Json one = section_schema(section.name);
    schema["properties"][section.name] = section.list ? Json{{"type", "array"}, {"minItems", 1}, {"items", one}} : one;
    if (section.needed) schema["required"].push_back(section.name);
  }
  return schema.dump(2) + "\n";
}

}  // namespace wetfront::verification
