#include "verification/foreign/point_data.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <sstream>

namespace wetfront::verification {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(" \t\r"), to = text.find_last_not_of(" \t\r");
  return from == std::string::npos ? "" : text.substr(from, to - from + 1);
}

/// The cells of a line; a separator within quotes is none.
std::vector<std::string> cells(const std::string& line, char separator) {
  std::vector<std::string> out(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"')
      quoted = !quoted;
    else if (c == separator && !quoted)
      out.emplace_back();
    else
      out.back() += c;
  }
  for (std::string& cell : out) cell = trimmed(cell);
  return out;
}

/// What parts the header into most cells: a comma, a semicolon or a tab.
char separator_of(const std::string& header) {
  char best = ',';
  for (const char one : {';', '\t'})
    if (cells(header, one).size() > cells(header, best).size()) best = one;
  return best;
}

bool read_number(const std::string& cell, double& value) {
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc{} && end == cell.data() + cell.size();
}

/// Which columns of the header are the coordinates; -1 where there is none.
std::array<std::ptrdiff_t, 3> place_columns(const std::vector<std::string>& header, const PlaceNames& names,
                                            const std::string& file) {
  std::array<std::ptrdiff_t, 3> found{-1, -1, -1};
  const char* axes[] = {"x", "y", "z"};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::string wanted = names[a].empty() ? axes[a] : names[a];
    const auto at = std::ranges::find(header, wanted);
    if (at != header.end())
      found[a] = at - header.begin();
    else if (!names[a].empty())
      cannot_read(file + ":1", "there is no column '" + wanted + "'", fmt::format("it has {}", fmt::join(header, ", ")),
                  "Name one of them in [columns].");
  }
  if (std::ranges::all_of(found, [](std::ptrdiff_t column) { return column < 0; }))
    cannot_read(file + ":1", "no column says where the points are", fmt::format("it has {}", fmt::join(header, ", ")),
                "Call them x, y, z, or name them in [columns] of the declaration.");
  return found;
}

}  // namespace

PointData read_csv_points(const std::string& content, const std::string& name, const PlaceNames& names) {
  std::stringstream in(content.starts_with("\xef\xbb\xbf") ? content.substr(3) : content);  // a byte-order mark
  std::string line;
  std::getline(in, line);
  const char separator = separator_of(line);
  const std::vector<std::string> header = cells(line, separator);
  PointData data;
  std::array<std::ptrdiff_t, 3> places{-1, -1, -1};
  for (int number = 2; std::getline(in, line); ++number) {
    if (trimmed(line).empty()) continue;
    if (data.position.empty()) places = place_columns(header, names, name);
    const std::vector<std::string> row = cells(line, separator);
    const std::string here = fmt::format("{}:{}", name, number);
    if (row.size() != header.size())
      cannot_read(here, fmt::format("this row has {} cells", row.size()),
                  fmt::format("the header has {}", header.size()), "Give each row as many.");
    std::array<double, 3> place{};
    for (std::size_t c = 0; c < row.size(); ++c) {
      const auto axis = std::ranges::find(places, static_cast<std::ptrdiff_t>(c)) - places.begin();
      double value = 0;
      const bool is_number = read_number(row[c], value);
      if (axis < 3 && !is_number)
        cannot_read(here, "'" + row[c].substr(0, 30) + "' is no number", "column " + header[c] + " holds places",
                    "Write it with a point and without a unit.");
      if (axis < 3)
        place[static_cast<std::size_t>(axis)] = value;
      else if (is_number)
        data.scalars[header[c]].push_back(value);
      else  // names, states, dates: nothing to compare, unless the declaration asks for them
        data.no_numbers.emplace(header[c], here + ": '" + row[c].substr(0, 30) + "' is no number");
    }
    data.position.push_back(place);
  }
  if (data.position.empty())
    cannot_read(name, "there are no points in it", "a header and rows are meant", "Begin with e.g. x,y,pressure.");
  for (const auto& [column, why] : data.no_numbers) data.scalars.erase(column);
  return data;
}

}  // namespace wetfront::verification
