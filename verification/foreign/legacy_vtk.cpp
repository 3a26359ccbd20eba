#include "verification/foreign/point_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cstdint>

namespace wetfront::verification {
namespace {

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// Big-endian bytes as a number.
template <class Number>
double number_at(const char* bytes) {
  std::array<char, sizeof(Number)> turned;
  std::reverse_copy(bytes, bytes + sizeof(Number), turned.begin());
  if constexpr (std::endian::native == std::endian::big) std::copy_n(bytes, sizeof(Number), turned.begin());
  return static_cast<double>(std::bit_cast<Number>(turned));
}

struct Type {
  std::size_t size;
  double (*read)(const char*);
};

Type type_named(const std::string& word, const std::string& file) {
  const std::string name = lower(word);
  if (name == "double") return {8, number_at<double>};
  if (name == "float") return {4, number_at<float>};
  if (name == "int") return {4, number_at<std::int32_t>};
  if (name == "unsigned_int") return {4, number_at<std::uint32_t>};
  if (name == "long" || name == "vtktypeint64" || name == "vtkidtype") return {8, number_at<std::int64_t>};
  if (name == "short") return {2, number_at<std::int16_t>};
  if (name == "char" || name == "signed_char") return {1, number_at<std::int8_t>};
  if (name == "unsigned_char" || name == "bit") return {1, number_at<std::uint8_t>};
  cannot_read(file, "'" + word + "' is no type of numbers", "legacy VTK knows float, double, int, ...",
              "Is the file damaged?");
}

/// Reads words, lines and blocks of numbers of a file in turn.
class Reader {
 public:
  Reader(const std::string& content, const std::string& file) : content_(content), file_(file) {}

  bool done() {
    skip_blanks();
    return at_ >= content_.size();
  }
  std::string line() {
    const std::size_t end = std::min(content_.find('\n', at_), content_.size());
    std::string text = content_.substr(at_, end - at_);
    at_ = std::min(end + 1, content_.size());
    if (!text.empty() && text.back() == '\r') text.pop_back();
    return text;
  }
  std::string word() {
    skip_blanks();
    const std::size_t start = at_;
    while (at_ < content_.size() && !std::isspace(static_cast<unsigned char>(content_[at_]))) ++at_;
    if (at_ == start) cannot_read(file_, "the file ends early", "more was announced", "Is it written to its end?");
    return content_.substr(start, at_ - start);
  }
  std::size_t count() { return count_of(word()); }
  std::size_t count_of(const std::string& text) const {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value > content_.size())
      cannot_read(file_, "'" + shortened(text) + "' is no count", "a whole number not above the file's size is meant",
                  "Is the file damaged?");
    return value;
  }
  std::vector<double> numbers(std::size_t count, const std::string& type, bool binary) {
    if (binary) return binary_numbers(count, type_named(type, file_));
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
      const std::string text = word();
      double value = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc{} && error != std::errc::result_out_of_range)
        cannot_read(file_, "'" + shortened(text) + "' is no number", "one was announced", "Is the file damaged?");
      values.push_back(value);
    }
    return values;
  }

 private:
  static std::string shortened(const std::string& text) { return text.substr(0, 30); }

  void skip_blanks() {
    while (at_ < content_.size() && std::isspace(static_cast<unsigned char>(content_[at_]))) ++at_;
  }
  /// Behind the end of the line that announced them.
  std::vector<double> binary_numbers(std::size_t count, Type type) {
    line();
    if (count > (content_.size() - at_) / type.size)
      cannot_read(file_, "the file ends early", fmt::format("{} numbers were announced", count),
                  "Is it written to its end?");
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = type.read(content_.data() + at_ + i * type.size);
    at_ += count * type.size;
    return values;
  }

  const std::string& content_;
  const std::string& file_;
  std::size_t at_ = 0;
};

class LegacyFile {
 public:
  LegacyFile(const std::string& content, const std::string& file) : in_(content, file), file_(file) {}

  PointData read() {
    in_.line();  // "# vtk DataFile Version 3.0"
    in_.line();  // title
    const std::string format = lower(in_.word());
    if (format != "ascii" && format != "binary")
      cannot_read(file_, "the third line says '" + format.substr(0, 30) + "'",
                  "ASCII or BINARY stands there in legacy VTK", "Is it such a file?");
    binary_ = format == "binary";
    while (!in_.done()) part(lower(in_.word()));
    if (data_.position.empty())
      cannot_read(file_, "there are no points in it", "POINTS is missing", "Name the file with the material points.");
    return std::move(data_);
  }

 private:
  void part(const std::string& key) {
    if (key == "dataset") {
      in_.word();
    } else if (key == "points") {
      const std::size_t count = in_.count();
      const auto values = in_.numbers(3 * count, in_.word(), binary_);
      for (std::size_t i = 0; i < count; ++i)
        data_.position.push_back({values[3 * i], values[3 * i + 1], values[3 * i + 2]});
    } else if (key == "cells" || key == "vertices" || key == "lines" || key == "polygons") {
      in_.count();
      in_.numbers(in_.count(), "int", binary_);
    } else if (key == "cell_types") {
      in_.numbers(in_.count(), "int", binary_);
    } else if (key == "point_data" || key == "cell_data") {
      at_points_ = key == "point_data";
      entries_ = in_.count();
    } else if (key == "scalars") {
      scalars();
    } else if (key == "vectors" || key == "normals" || key == "tensors") {
      const std::string name = in_.word(), type = in_.word();
      keep(name, in_.numbers((key == "tensors" ? 9 : 3) * entries_, type, binary_), key == "tensors" ? 9 : 3);
    } else if (key == "field") {
      in_.word();
      for (std::size_t arrays = in_.count(); arrays > 0; --arrays) {
        const std::string name = in_.word();
        const std::size_t components = in_.count(), tuples = in_.count();
        const std::string type = in_.word();
        const auto values = in_.numbers(components * tuples, type, binary_);
        if (tuples == data_.position.size()) keep(name, values, components);
      }
    } else if (key == "metadata") {
      while (!in_.line().empty()) {
      }
    } else {
      cannot_read(file_, "'" + key.substr(0, 30) + "' is not understood",
                  "it is none of the parts of legacy VTK that hold points", "Write an unstructured grid or polydata.");
    }
  }
  void scalars() {
    const std::string name = in_.word(), type = in_.word();
    std::size_t components = 1;
    std::string next = in_.word();
    if (lower(next) != "lookup_table") {
      components = in_.count_of(next);
      in_.word();  // LOOKUP_TABLE
    }
    in_.word();  // default
    keep(name, in_.numbers(components * entries_, type, binary_), components);
  }
  void keep(const std::string& name, const std::vector<double>& values, std::size_t components) {
    if (at_points_ && components > 0) add_components(data_, name, values, components);
  }

  Reader in_;
  const std::string& file_;
  PointData data_;
  bool binary_ = false, at_points_ = false;
  std::size_t entries_ = 0;
};

}  // namespace

PointData read_legacy_vtk(const std::string& content, const std::string& name) {
  return LegacyFile(content, name).read();
}

}  // namespace wetfront::verification
