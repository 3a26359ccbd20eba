#include "verification/scene/document.h"

#include "verification/scene/read.h"

#include <toml++/toml.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace wetfront::verification {
namespace {

Place place_of(const toml::source_region& source) {
  return {std::max(1, static_cast<int>(source.begin.line)), std::max(1, static_cast<int>(source.begin.column))};
}

Value convert(const toml::node& node) {
  Value value;
  value.place = place_of(node.source());
  value.end = {static_cast<int>(node.source().end.line), static_cast<int>(node.source().end.column)};
  switch (node.type()) {
    case toml::node_type::table:
      value.kind = Value::Kind::table;
      for (auto&& [key, child] : *node.as_table())
        value.entries.push_back({std::string(key.str()), place_of(key.source()), convert(child)});
      break;
    case toml::node_type::array:
      value.kind = Value::Kind::array;
      for (const toml::node& child : *node.as_array()) value.items.push_back(convert(child));
      break;
    case toml::node_type::string:
      value.kind = Value::Kind::text;
      value.text = node.as_string()->get();
      break;
    case toml::node_type::integer:
      value.kind = Value::Kind::integer;
      value.number = static_cast<double>(node.as_integer()->get());
      break;
    case toml::node_type::floating_point:
      value.kind = Value::Kind::real;
      value.number = node.as_floating_point()->get();
      break;
    case toml::node_type::boolean:
      value.kind = Value::Kind::boolean;
      value.number = node.as_boolean()->get();
      break;
    default:
      value.kind = Value::Kind::date;
  }
  return value;
}

/// toml++ says "Error while parsing key-value pair: cannot redefine existing string 'cells'".
Complaint explain(const std::string& description) {
  const auto colon = description.find(": ");
  const std::string detail = colon == std::string::npos ? description : description.substr(colon + 2);
  const auto says = [&](const char* words) { return description.find(words) != std::string::npos; };
  if (says("redefine")) {
    const auto quote = detail.find('\'');
    const std::string what = quote == std::string::npos ? "this" : detail.substr(quote);
    const bool table = says("table") || says("array");
    return {"duplicate key " + what, "the file gives it twice and only one could count",
            table ? "Keep one of the two; what there may be several of (soil, rain, stage, ...) is written [[...]]."
                  : "Keep one of the two."};
  }
  const auto saw = description.find("saw '");
  const bool letter = saw != std::string::npos && std::isalpha(static_cast<unsigned char>(description[saw + 5]));
  return {"this is not TOML", detail,
          letter || says("could not determine value type")
              ? "Text and values with a unit stand in quotation marks, as in height = \"1.2 m\"."
              : "See https://toml.io for the grammar, or start from `wetfront new NAME`."};
}

}  // namespace

const Entry* Value::find(const std::string& key) const {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

std::string Value::shown() const {
  switch (kind) {
    case Kind::table:
      return entries.empty() ? "{}" : "{ " + entries.front().key + " = ... }";
    case Kind::array: {
      std::string list;
      for (const Value& item : items) list += (list.empty() ? "" : ", ") + item.shown();
      return '[' + shortened(list) + ']';
    }
    case Kind::text:
      return '"' + shortened(text) + '"';
    case Kind::integer:
    case Kind::real:
      return fmt::format("{}", number);
    case Kind::boolean:
      return number != 0 ? "true" : "false";
    case Kind::date:
      break;
  }
  return "a date";
}

Value parse_document(const std::string& text, const std::string& file) {
  try {
    return convert(toml::parse(text, file));
  } catch (const toml::parse_error& error) {
    Complaints complaints(file);
    complaints.add(place_of(error.source()), explain(std::string(error.description())));
    throw SceneError(complaints.in_order());
  }
}

}  // namespace wetfront::verification
