#include "verification/suites/hard/hard_suite.h"

#include "reports/write.h"
#include "verification/compare/verdict.h"
#include "verification/suites/hard/families.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace wetfront::verification {
namespace {

constexpr const char* matrix_folder = "matrix";

/// "FAIL (bound): 2.3 / 1 cells", "refused: too expensive: about ...", "stable, within bound: ...".
std::string cell_text(const std::vector<std::string>& entry) {
  const std::string &verdict = entry.at(1), &error = entry.at(2), &said = entry.at(10);
  if (!error.empty() && error != "-")
    return verdict + ": " + error + (entry.at(9).empty() ? "" : "; CPU " + entry.at(9));
  return said.empty() ? verdict : verdict + ": " + said;
}

/// The matrix from the pages of its rows.
reports::Record matrix(const std::vector<reports::Record>& rows) {
  reports::Record record;
  record.case_name = matrix_folder;
  record.title = "Hard cases: rows are scenes, columns are schemes";
  record.requirement =
      "No entry may be a NaN, a hang or a silent wrong answer: it is stable within its bound, or refused for a reason.";
  reports::Table table{
      "The matrix", "Verdicts", "Errors over their bounds; each row's page has the rest.", {"case"}, {}};
  for (const HardScheme scheme : hard_schemes) table.header.push_back(key(scheme));
  int failed = 0;
  for (const reports::Record& row : rows) {
    std::vector<std::string> line{row.title};
    for (const reports::Table& entries : row.tables)
      if (entries.title == "Entries")
        for (const auto& entry : entries.rows) {
          line.push_back(cell_text(entry));
          failed += entry.at(1).starts_with("FAIL");
        }
    line.resize(table.header.size());
    table.rows.push_back(line);
    record.cpu_seconds += row.cpu_seconds;
    if (record.provenance.empty()) record.provenance = row.provenance;
  }
  reports::Finding& finding = record.findings.emplace_back();
  finding.quantity = "failed_entries";
  finding.description = fmt::format("entries that fail, of {} rows", rows.size());
  finding.unit = "entries";
  finding.error = failed;
  finding.reason = "what fails stays visible as such";
  finding.verdict = failed == 0 ? reports::Verdict::pass : reports::Verdict::fail;
  record.verdict = finding.verdict;
  record.tables.push_back(table);
  return record;
}

}  // namespace

std::vector<Case> hard_suite() {
  std::vector<Case> all;
  for (const auto family : {dry_rows, layer_rows, water_rows, rain_rows, surface_rows, invalid_rows})
    for (const HardCase& row : family()) all.push_back(as_case(row));
  return all;
}

bool run_hard_suite(const SuiteOptions& options) {
  const std::vector<Case> suite = hard_suite();
  const std::string title = "Hard cases";
  const bool passed = run_suite(suite, options, title);
  std::vector<std::filesystem::path> folders;
  std::vector<reports::Record> rows;
  for (const Case& test : suite) {
    if ((test.effort == Effort::heavy && !options.heavy) || test.name.find(options.only) == std::string::npos) continue;
    folders.push_back(options.out / test.name);
    rows.push_back(reports::read_result(folders.back() / "result.json"));
  }
  reports::write_result(matrix(rows), options.out / matrix_folder);
  reports::write_index(std::vector<reports::RunGroup>{{"The matrix in words", {options.out / matrix_folder}},
                                                      {"Verdict by scheme", folders}},
                       options.out / "index.html", title);
  return passed;
}

}  // namespace wetfront::verification
