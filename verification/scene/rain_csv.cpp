#include "verification/scene/reading.h"
#include "verification/scene/units.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <sstream>

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
  if (heading.rfind(name, 0) != 0 || open == std::string::npos || close == std::string::npos || close < open) return "";
  return heading.substr(open + 1, close - open - 1);
}

/// Reads the table row by row; complaints carry the CSV's own line.
class RainCsv {
 public:
  RainCsv(const std::filesystem::path& path, Place named_at, Complaints& complaints)
      : path_(path.string()), named_at_(named_at), complaints_(complaints) {}

  meshes::RainRecord read(std::istream& file) {
    std::string line;
    while (std::getline(file, line)) {
      if (++line_ == 1 && line.rfind("\xef\xbb\xbf", 0) == 0) line.erase(0, 3);  // spreadsheets mark UTF-8 so
      if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
      if (units_[0].empty() && !read_header(line))
        return {};
      else if (headed_)
        read_row(line);
      headed_ = true;
    }
    if (!headed_)
      complain(1, {"the rain record is empty", "it needs a header and one row",
                   "Start it with the line: time [s], intensity [mm/h]"});
    else if (record_.start.empty() && !failed_)
      complain(1, {"the rain record has no rows", "nothing says how much rain falls", "Add a row such as: 0, 100"});
    for (const RainFault& fault : faults_of(record_)) {
      line_ = rows_[fault.row];
      complain(1, fault.complaint);
    }
    return failed_ ? meshes::RainRecord{} : record_;
  }

 private:
  void complain(int column, const Complaint& complaint) {
    failed_ = true;
    complaints_.add_elsewhere(named_at_, path_, {line_ > 0 ? line_ : 1, column}, complaint);
  }

  bool read_header(const std::string& line) {
    const std::vector<Cell> cells = cells_of(line);
    if (cells.size() == 2) units_[0] = unit_in(cells[0].text, "time"), units_[1] = unit_in(cells[1].text, "intensity");
    if (units_[0].empty() || units_[1].empty()) {
      complain(1, {"the rain record has no header with units", "bare numbers could be in any unit",
                   "Start it with the line: time [s], intensity [mm/h]"});
      return false;
    }
    bool sound = true;
    for (int i : {0, 1}) {
      const auto read = read_quantity("1 " + units_[i], wanted_[i]);
      if (!std::holds_alternative<Complaint>(read)) continue;
      const Complaint& wrong = std::get<Complaint>(read);
      const std::string quoted = "\"1 " + units_[i] + '"';
      const std::string rest =
          wrong.problem.rfind(quoted, 0) == 0 ? wrong.problem.substr(quoted.size()) : wrong.problem;
      complain(cells[i].column,
               {'[' + units_[i] + ']' + rest, wrong.why, "Write the header as: time [s], intensity [mm/h]"});
      sound = false;
    }
    return sound;
  }

  void read_row(const std::string& line) {
    const std::vector<Cell> cells = cells_of(line);
    if (cells.size() != 2) {
      complain(1, {fmt::format("this row has {} value{}, not 2", cells.size(), cells.size() == 1 ? "" : "s"),
                   "a row is a time and an intensity", "Write it as in: 0, 100"});
      return;
    }
    double values[2];
    for (int i : {0, 1}) {
      const auto read = read_quantity(cells[i].text, "1");
      const double* number = std::get_if<double>(&read);
      if (!number || cells[i].text.find('%') != std::string::npos) {
        complain(cells[i].column, {'"' + cells[i].text + "\" is not a number",
                                   "the unit stands in the header, " + units_[i], "Write it as in: 0, 100"});
        return;
      }
      values[i] = *number * std::get<double>(read_quantity("1 " + units_[i], wanted_[i]));
    }
    record_.start.push_back(values[0]);
    record_.intensity.push_back(values[1]);
    rows_.push_back(line_);
  }

  std::string path_;
  Place named_at_;
  Complaints& complaints_;
  const std::string wanted_[2] = {"s", "m/s"};
  std::string units_[2];
  meshes::RainRecord record_;
  std::vector<int> rows_;
  int line_ = 0;
  bool headed_ = false, failed_ = false;
};

}  // namespace

meshes::RainRecord read_rain_csv(const std::filesystem::path& path, Place named_at, Complaints& complaints) {
  std::ifstream file(path);
  std::error_code error;
  if (!file || !std::filesystem::is_regular_file(path, error)) {
    complaints.add(named_at, {"the rain record cannot be read", "there is no file " + path.string(),
                              "The path is relative to the scene's folder."});
    return {};
  }
  return RainCsv(path, named_at, complaints).read(file);
}

std::vector<RainFault> faults_of(const meshes::RainRecord& record) {
  std::vector<RainFault> faults;
  for (std::size_t i = 0; i < record.start.size(); ++i) {
    const double before = i == 0 ? 0 : record.start[i - 1];
    if (i > 0 && record.start[i] <= before)
      faults.push_back(
          {i,
           {"the times of the rain do not ascend", fmt::format("{:g} s follows {:g} s", record.start[i], before),
            "Sort the record by time, each time once."}});
    if (i == 0 && record.start[i] < 0)
      faults.push_back(
          {i, {"the rain starts before the run", fmt::format("at {:g} s", record.start[i]), "The run starts at 0 s."}});
    if (record.intensity[i] < 0)
      faults.push_back({i,
                        {"the rain intensity is negative", fmt::format("{:g} m/s", record.intensity[i]),
                         "Write 0 where it is dry."}});
    if (record.intensity[i] > 0.1)
      faults.push_back(
          {i,
           {"the rain intensity is out of range", fmt::format("{:g} m/s is more than 0.1 m/s", record.intensity[i]),
            "Check the unit and the exponent."}});
  }
  return faults;
}

}  // namespace wetfront::verification
