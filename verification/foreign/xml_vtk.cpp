#include "reports/base64.h"
#include "verification/foreign/point_data.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <cstring>

namespace wetfront::verification {
namespace {

/// A tag with its attributes and the text between it and its end.
struct Element {
  std::string attributes, text;
  std::string attribute(const std::string& name) const {
    const std::string begin = " " + name + "=\"";
    const std::size_t at = attributes.find(begin);
    if (at == std::string::npos) return "";
    const std::size_t from = at + begin.size();
    return attributes.substr(from, attributes.find('"', from) - from);
  }
};

std::vector<Element> elements(const std::string& text, const std::string& tag, const std::string& file) {
  std::vector<Element> found;
  for (std::size_t at = text.find("<" + tag); at != std::string::npos; at = text.find("<" + tag, at + 1)) {
    const char next = text[at + tag.size() + 1];
    if (next != ' ' && next != '>' && next != '\n' && next != '/') continue;
    const std::size_t close = text.find('>', at);
    if (close == std::string::npos)
      cannot_read(file, "a tag does not end", "<" + tag, "Is the file written to its end?");
    std::string attributes = text.substr(at + tag.size() + 1, close - at - tag.size() - 1);
    for (char& c : attributes)
      if (c == '\n' || c == '\t') c = ' ';
    if (!attributes.empty() && attributes.back() == '/') {
      found.push_back({attributes, ""});
      continue;
    }
    const std::size_t end = text.find("</" + tag + ">", close);
    if (end == std::string::npos)
      cannot_read(file, "<" + tag + "> does not end", "its closing tag is missing", "Is the file written to its end?");
    found.push_back({attributes, text.substr(close + 1, end - close - 1)});
  }
  return found;
}

template <class Number>
std::vector<double> numbers_of(const std::vector<unsigned char>& bytes, std::size_t from) {
  std::vector<double> values;
  for (std::size_t at = from; at + sizeof(Number) <= bytes.size(); at += sizeof(Number)) {
    Number value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    values.push_back(static_cast<double>(value));
  }
  return values;
}

std::vector<double> values_of(const Element& array, const Element& whole, const std::string& file) {
  const std::string type = array.attribute("type"), format = array.attribute("format");
  if (format == "ascii") {
    std::vector<double> values;
    const char* at = array.text.data();
    const char* end = at + array.text.size();
    while (true) {
      while (at != end && std::isspace(static_cast<unsigned char>(*at))) ++at;
      if (at == end) return values;
      double value = 0;
      const auto [next, error] = std::from_chars(at, end, value);
      if (next == at) cannot_read(file, "a number is none", "in " + array.attribute("Name"), "Is the file damaged?");
      values.push_back(value);
      at = next;
    }
  }
  if (format != "binary" || !whole.attribute("compressor").empty() || whole.attribute("byte_order") == "BigEndian")
    cannot_read(file, "the array " + array.attribute("Name") + " is written in a way that is not read",
                "ASCII and inline base64, little-endian and not compressed, are",
                "Write it so, e.g. by ParaView's \"ascii\".");
  const auto bytes = reports::from_base64_parts(array.text);
  const std::size_t head = whole.attribute("header_type") == "UInt64" ? 8 : 4;
  if (type == "Float64") return numbers_of<double>(bytes, head);
  if (type == "Float32") return numbers_of<float>(bytes, head);
  if (type == "Int32") return numbers_of<std::int32_t>(bytes, head);
  if (type == "Int64") return numbers_of<std::int64_t>(bytes, head);
  if (type == "UInt8") return numbers_of<std::uint8_t>(bytes, head);
  cannot_read(file, "'" + type + "' is no type of numbers that is read", "in " + array.attribute("Name"),
              "Write Float64.");
}

}  // namespace

PointData read_xml_vtk(const std::string& content, const std::string& name) {
  PointData data;
  const auto files = elements(content, "VTKFile", name);
  if (files.empty()) cannot_read(name, "there is no VTKFile in it", "it begins as one", "Is the file damaged?");
  const Element& whole = files.front();
  for (const Element& points : elements(whole.text, "Points", name))
    for (const Element& array : elements(points.text, "DataArray", name)) {
      const auto values = values_of(array, whole, name);
      for (std::size_t i = 0; i + 2 < values.size(); i += 3)
        data.position.push_back({values[i], values[i + 1], values[i + 2]});
    }
  if (data.position.empty())
    cannot_read(name, "there are no points in it", "<Points> is missing or empty",
                "Name the file with the material points.");
  for (const Element& at_points : elements(whole.text, "PointData", name))
    for (const Element& array : elements(at_points.text, "DataArray", name)) {
      const auto values = values_of(array, whole, name);
      const std::string field = array.attribute("Name");
      const std::size_t components = values.size() / data.position.size();
      if (components == 0 || components * data.position.size() != values.size())
        cannot_read(name, "the array " + field + " does not fit the points",
                    fmt::format("{} values for {} points", values.size(), data.position.size()),
                    "Is the file written to its end?");
      add_components(data, field, values, components);
    }
  return data;
}

}  // namespace wetfront::verification
