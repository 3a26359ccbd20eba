#include "reports/run_history.h"

#include "reports/escape.h"
#include "reports/json_number.h"
#include "reports/number_text.h"
#include "reports/record_json.h"
#include "reports/whole_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>

namespace wetfront::reports {

namespace {

using Json = nlohmann::ordered_json;

std::string told(const Record& record, const std::string& key) {
  const auto found = record.provenance.find(key);
  return found == record.provenance.end() ? "" : found->second;
}

Json line_of(const Record& record) {
  Json line = {{"date", told(record, "date")},
               {"git_hash", told(record, "git_hash")},
               {"dirty", told(record, "dirty") == "true"},
               {"verdict", verdict_key(record.verdict)},
               {"cpu_s", number_json(record.cpu_seconds)},
               {"values", Json::array()}};
  std::map<std::string, int> numbers;
  for (const Finding& finding : record.findings)
    if (const int number = numbers[finding.quantity]++; finding.verdict != Verdict::info)
      line["values"].push_back({{"quantity", finding.quantity},
                                {"number", number},
                                {"error", number_json(finding.error)},
                                {"tolerance", number_json(finding.tolerance)},
                                {"verdict", verdict_key(finding.verdict)}});
  return line;
}

PastRun run_from(const Json& line) {
  PastRun run{line.at("date").get<std::string>(), line.at("git_hash").get<std::string>(),
              line.at("dirty").get<bool>(),       verdict_from(line.at("verdict").get<std::string>()),
              number_from(line.at("cpu_s")),      {}};
  for (const Json& value : line.at("values"))
    run.values.push_back({value.at("quantity").get<std::string>(), value.at("number").get<int>(),
                          number_from(value.at("error")), number_from(value.at("tolerance")),
                          verdict_from(value.at("verdict").get<std::string>())});
  return run;
}

/// Whether the last line lacks its end: a kill or a full disk cut it.
bool torn(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in || in.tellg() <= 0) return false;
  in.seekg(-1, std::ios::end);
  return in.get() != '\n';
}

constexpr const char* file_name = "history.jsonl";

struct Dot {
  const PastRun* run;
  const PastRun::Value* value;
};

std::string title_of(const std::vector<Dot>& dots, const std::string& unit) {
  std::string text;
  for (const auto& [run, value] : dots)
    text += (text.empty() ? "" : "\n") + run->date + ", " + run->commit.substr(0, 8) + (run->dirty ? "+" : "") + ": " +
            quantity_text(value->error, unit);
  return text;
}

}  // namespace

void remember(const Record& record, const std::filesystem::path& folder) {
  if (told(record, "date").empty()) return;
  const auto before = past_runs(folder, 1);
  if (!before.empty() && before.back().date == told(record, "date") && before.back().commit == told(record, "git_hash"))
    return;
  make_folder(folder);
  const std::filesystem::path file = folder / file_name;
  std::ofstream out(file, std::ios::app);
  const std::string line = line_of(record).dump(-1, ' ', false, Json::error_handler_t::replace);
  out << (torn(file) ? "\n" : "") << line << "\n" << std::flush;
  if (!out) throw std::runtime_error(file.string() + ": cannot write (" + std::strerror(errno) + ")");
}

std::vector<PastRun> past_runs(const std::filesystem::path& folder, std::size_t most) {
  std::vector<std::string> lines;
  std::ifstream in(folder / file_name);
  for (std::string line; std::getline(in, line);) lines.push_back(std::move(line));
  std::vector<PastRun> runs;  // from the newest, so that no more are parsed than are asked for
  for (auto line = lines.rbegin(); line != lines.rend() && runs.size() < most; ++line) try {
      runs.push_back(run_from(Json::parse(*line)));
    } catch (const std::exception&) {
      continue;  // torn by a full disk or a kill: the others still tell
    }
  std::ranges::reverse(runs);
  return runs;
}

std::string trend(const std::vector<PastRun>& runs, const std::string& quantity, int number, const std::string& unit) {
  constexpr double width = 84, limit = 6, base = 18;
  std::vector<Dot> dots;
  for (const PastRun& run : runs)
    for (const PastRun::Value& value : run.values)
      if (value.quantity == quantity && value.number == number && value.tolerance > 0 && !std::isnan(value.error))
        dots.push_back({&run, &value});
  if (dots.size() < 2) return "";
  std::ostringstream line, marks;
  for (std::size_t i = 0; i < dots.size(); ++i) {
    const double share = std::min(1.4, std::abs(dots[i].value->error) / dots[i].value->tolerance);
    const double x = width - 4 - 7 * static_cast<double>(dots.size() - 1 - i), y = base - share * (base - limit);
    if (x < 2) continue;
    line << (line.str().empty() ? "M" : "L") << x << " " << y;
    marks << "<circle class=\"" << verdict_key(dots[i].value->verdict) << "\" cx=\"" << x << "\" cy=\"" << y
          << "\" r=\"" << (i + 1 == dots.size() ? 2.6 : 1.5) << "\"/>";
  }
  std::ostringstream out;
  out << "<svg class=\"trend\" viewBox=\"0 0 84 20\" width=\"84\" height=\"20\" role=\"img\" aria-label=\"the last "
      << dots.size() << " runs\"><title>" << html(title_of(dots, unit)) << "</title><path class=\"limit\" d=\"M0 "
      << limit << "H" << width << "\"/><path class=\"line\" d=\"" << line.str() << "\"/>" << marks.str() << "</svg>";
  return out.str();
}

}  // namespace wetfront::reports
