#include "verification/foreign/point_data.h"

#include <fmt/format.h>

#include <charconv>
#include <sstream>

namespace wetfront::verification {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(" \t\r\""), to = text.find_last_not_of(" \t\r\"");
  return from == std::string::npos ? "" : text.substr(from, to - from + 1);
}

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out;
  std::stringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) out.push_back(trimmed(cell));
  return out;
}

}  // namespace

/// Columns x, y and z (as far as they are there) are places; all others are values.
PointData read_csv_points(const std::string& content, const std::string& name) {
  std::stringstream in(content);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> header = cells(line);
  PointData data;
  int number = 1;
  while (std::getline(in, line)) {
    ++number;
    if (trimmed(line).empty()) continue;
    const std::vector<std::string> row = cells(line);
    if (row.size() != header.size())
      cannot_read(fmt::format("{}:{}", name, number), fmt::format("this row has {} cells", row.size()),
                  fmt::format("the header has {}", header.size()), "Give each row as many.");
    std::array<double, 3> place{};
    for (std::size_t c = 0; c < row.size(); ++c) {
      double value = 0;
      const auto [end, error] = std::from_chars(row[c].data(), row[c].data() + row[c].size(), value);
      if (error != std::errc{} || end != row[c].data() + row[c].size())
        cannot_read(fmt::format("{}:{}", name, number), "'" + row[c].substr(0, 30) + "' is no number",
                    "column " + header[c] + " holds numbers", "Write it with a point and without a unit.");
      const std::string& column = header[c];
      if (column == "x" || column == "y" || column == "z")
        place[static_cast<std::size_t>(column[0] - 'x')] = value;
      else
        data.scalars[column].push_back(value);
    }
    data.position.push_back(place);
  }
  if (data.position.empty())
    cannot_read(name, "there are no points in it", "a header and rows are meant", "Begin with e.g. x,y,pressure.");
  return data;
}

}  // namespace wetfront::verification
