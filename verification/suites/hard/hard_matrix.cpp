#include "verification/suites/hard/hard_matrix.h"

#include "reports/quantity_anchor.h"
#include "verification/suites/hard/hard_case.h"

#include <fmt/format.h>

#include <algorithm>

namespace wetfront::verification {
namespace {

/// "FAIL (bound): 2.3 / 1 cells", "refused: too expensive: about ...", "stable, within bound: ...", from an entry of
/// the table that hard_page.cpp writes.
std::string cell_text(const std::vector<std::string>& entry) {
  const std::string &verdict = entry.at(1), &error = entry.at(2), &said = entry.at(10);
  if (!error.empty() && error != "-")
    return verdict + ": " + error + (entry.at(9).empty() ? "" : "; CPU " + entry.at(9));
  return said.empty() ? verdict : verdict + ": " + said;
}

const reports::Table* entries_of(const reports::Record& row, const std::string& title) {
  const auto found = std::ranges::find(row.tables, title, &reports::Table::title);
  return found == row.tables.end() ? nullptr : &*found;
}

/// A line of the matrix, under the schemes of its header; the number of entries that fail.
int add_row(reports::Table& table, const reports::Record& row, const reports::Table& entries) {
  const std::string page = "../" + row.case_name + "/report.html";
  std::vector<std::string> line(table.header.size());
  std::vector<reports::Table::Mark> marks(table.header.size());
  line[0] = row.title;
  int failed = 0;
  for (const auto& entry : entries.rows) {
    const auto column = static_cast<std::size_t>(std::ranges::find(table.header, entry.at(0)) - table.header.begin());
    const bool fails = entry.at(1).starts_with("FAIL"), refused = entry.at(1).starts_with("refused");
    line.at(column) = cell_text(entry);
    marks.at(column) = {fails     ? "fail"
                        : refused ? "refused"
                                  : "pass",
                        page + "#" + reports::quantity_anchor(entry.at(0))};
    failed += fails;
  }
  table.rows.push_back(line);
  table.links.push_back(page);
  table.marks.push_back(marks);
  return failed;
}

/// The rows that have entries of one kind, under all schemes that any of them names.
int add_table(reports::Record& record, const std::vector<reports::Record>& rows, const char* title, const char* kind) {
  reports::Table table{title,
                       "Verdicts",
                       "Stable and within its bound, refused for a reason, or FAIL; errors over their bounds. Each "
                       "row's page has the rest.",
                       {"case"},
                       {}};
  std::vector<std::pair<const reports::Record*, const reports::Table*>> found;
  for (const reports::Record& row : rows) {
    const reports::Table* entries = entries_of(row, kind);
    if (entries == nullptr) continue;
    found.emplace_back(&row, entries);
    for (const auto& entry : entries->rows)
      if (std::ranges::count(table.header, entry.at(0)) == 0) table.header.push_back(entry.at(0));
  }
  int failed = 0;
  for (const auto& [row, entries] : found) failed += add_row(table, *row, *entries);
  if (!found.empty()) record.tables.push_back(table);
  return failed;
}

}  // namespace

reports::Record hard_matrix(const std::vector<reports::Record>& rows) {
  reports::Record record;
  record.case_name = hard_matrix_folder;
  record.title = "Hard cases: rows are scenes, columns are schemes";
  record.requirement =
      "No entry may be a NaN, a hang or a silent wrong answer: it is stable within its bound, or refused for a reason.";
  const int failed = add_table(record, rows, "Stability of the hard cases", rigid_entries) +
                     add_table(record, rows, "The same with a deforming skeleton", deforming_entries);
  for (const reports::Record& row : rows) {
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
  return record;
}

}  // namespace wetfront::verification
