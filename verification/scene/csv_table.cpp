#include "verification/scene/csv_table.h"

#include "verification/scene/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace wetfront::verification {
namespace {

struct Cell {
  int column;  ///< from 1
  std::string text;
};

std::vector<Cell> cells_of(const std::string& line) {
  std::vector<Cell> cells;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t comma = std::min(line.find(',', from), line.size());
    const std::size_t first = std::min(line.find_first_not_of(" \t\r", from), comma);
    const std::size_t last = line.find_last_not_of(" \t\r", comma == 0 ? 0 : comma - 1);
    const bool blank = first >= comma || last == std::string::npos || last < first;
    cells.push_back({static_cast<int>(first) + 1, blank ? "" : line.substr(first, last - first + 1)});
    from = comma + 1;
  }
  return cells;
}

/// "intensity [mm/h]" -> "mm/h"; "" when the heading is not that.
std::string unit_in(const std::string& heading, const std::string& name) {
  const auto open = heading.find('['), close = heading.find(']');
  if (open == std::string::npos || close == std::string::npos || close < open) return "";
  std::string given = heading.substr(0, open);
  given.erase(given.find_last_not_of(" \t") + 1);
  if (given != name) return "";
  const std::string unit = heading.substr(open + 1, close - open - 1);
  return unit == "-" ? "1" : unit;
}

/// Reads the table row by row; complaints carry the CSV's own line.
class CsvReader {
 public:
  CsvReader(const std::filesystem::path& path, const CsvForm& form, double unit_weight, Place named_at,
            Complaints& complaints)
      : path_(path.string()), form_(form), unit_weight_(unit_weight), named_at_(named_at), complaints_(complaints) {
    example_ = form.header.empty() ? csv_header(form.headers.front()) : form.header;
  }

  CsvTable read(std::istream& file) {
    std::string line;
    while (std::getline(file, line)) {
      if (++line_ == 1 && line.rfind("\xef\xbb\xbf", 0) == 0) line.erase(0, 3);  // spreadsheets mark UTF-8 so
      if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
      if (units_.empty() && !read_header(line)) return table_;
      if (headed_) read_row(line);
      headed_ = true;
    }
    if (!headed_)
      complain(1, {"the " + form_.what + " is empty", "it needs a header and one row",
                   "Start it with the line: " + example_});
    else if (table_.rows() == 0 && table_.sound)
      complain(1,
               {"the " + form_.what + " has no rows", "nothing follows its header", "Add a row such as: " + form_.row});
    return table_;
  }

 private:
  void complain(int column, const Complaint& complaint) {
    table_.sound = false;
    complaints_.add_elsewhere(named_at_, path_, {line_ > 0 ? line_ : 1, column}, complaint);
  }

  /// Units of the header's cells; empty where the columns are others.
  static std::vector<std::string> units_in(const std::vector<Cell>& cells, const std::vector<TableColumn>& columns) {
    std::vector<std::string> units;
    for (std::size_t i = 0; i < columns.size() && cells.size() == columns.size(); ++i) {
      units.push_back(unit_in(cells[i].text, columns[i].name));
      if (units.back().empty()) return {};
    }
    return units;
  }

  bool read_header(const std::string& line) {
    table_.sound = true;
    const std::vector<Cell> cells = cells_of(line);
    for (table_.header = 0; table_.header < form_.headers.size(); ++table_.header)
      if (units_ = units_in(cells, form_.headers[table_.header]); !units_.empty()) break;
    if (units_.empty()) {
      complain(1, {"the " + form_.what + " has no header with units", "bare numbers could be in any unit",
                   "Start it with the line: " + example_});
      return false;
    }
    const std::vector<TableColumn>& columns = form_.headers[table_.header];
    table_.column.resize(columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const std::string one = units_[i] == "1" ? "1" : "1 " + units_[i];
      const auto read = read_quantity(one, columns[i].unit, unit_weight_);
      if (const double* scale = std::get_if<double>(&read)) {
        scale_.push_back(*scale);
        continue;
      }
      const Complaint& wrong = std::get<Complaint>(read);
      const std::string quoted = '"' + one + '"';
      const std::string rest =
          wrong.problem.rfind(quoted, 0) == 0 ? wrong.problem.substr(quoted.size()) : wrong.problem;
      complain(cells[i].column, {'[' + units_[i] + ']' + rest, wrong.why, "Write the header as: " + example_});
    }
    return table_.sound;
  }

  void read_row(const std::string& line) {
    const std::vector<Cell> cells = cells_of(line);
    if (cells.size() != units_.size()) {
      complain(
          1, {fmt::format("this row has {} value{}, not {}", cells.size(), cells.size() == 1 ? "" : "s", units_.size()),
              "the header has that many columns", "Write it as in: " + form_.row});
      return;
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto read = read_quantity(cells[i].text, "1");
      const double* number = std::get_if<double>(&read);
      if (!number || cells[i].text.find('%') != std::string::npos) {
        complain(cells[i].column, {'"' + shortened(cells[i].text) + "\" is not a number",
                                   "the unit stands in the header, " + (units_[i] == "1" ? "-" : units_[i]),
                                   "Write it as in: " + form_.row});
        return;
      }
      values.push_back(*number * scale_[i]);
    }
    for (std::size_t i = 0; i < values.size(); ++i) table_.column[i].push_back(values[i]);
    table_.line.push_back(line_);
  }

  std::string path_;
  const CsvForm& form_;
  double unit_weight_;
  Place named_at_;
  Complaints& complaints_;
  std::string example_;
  std::vector<std::string> units_;
  std::vector<double> scale_;
  CsvTable table_;
  int line_ = 0;
  bool headed_ = false;
};

}  // namespace

CsvTable read_csv(const std::filesystem::path& path, const CsvForm& form, double unit_weight, Place named_at,
                  Complaints& complaints) {
  std::ifstream file(path);
  std::error_code error;
  if (!file || !std::filesystem::is_regular_file(path, error)) {
    complaints.add(named_at, {"the " + form.what + " cannot be read", "there is no file " + path.string(),
                              "The path is relative to the scene's folder."});
    return {};
  }
  return CsvReader(path, form, unit_weight, named_at, complaints).read(file);
}

}  // namespace wetfront::verification
