#include "verification/suites/hard/hard_matrix.h"

#include "reports/quantity_anchor.h"

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

const reports::Table* entries_of(const reports::Record& row) {
  const auto found = std::ranges::find(row.tables, "Entries", &reports::Table::title);
  return found == row.tables.end() ? nullptr : &*found;
}

/// A line of the matrix; the number of entries that fail.
int add_row(reports::Table& table, const reports::Record& row) {
  const std::string page = "../" + row.case_name + "/report.html";
  std::vector<std::string> line{row.title};
  std::vector<reports::Table::Mark> marks{{}};
  int failed = 0;
  if (const reports::Table* entries = entries_of(row))
    for (const auto& entry : entries->rows) {
      line.push_back(cell_text(entry));
      const bool fails = entry.at(1).starts_with("FAIL"), refused = entry.at(1).starts_with("refused");
      marks.push_back({fails     ? "fail"
                       : refused ? "refused"
                                 : "pass",
                       page + "#" + reports::quantity_anchor(entry.at(0))});
      failed += fails;
    }
  line.resize(table.header.size());
  table.rows.push_back(line);
  table.links.push_back(page);
  table.marks.push_back(marks);
  return failed;
}

}  // namespace

reports::Record hard_matrix(const std::vector<reports::Record>& rows) {
  reports::Record record;
  record.case_name = hard_matrix_folder;
  record.title = "Hard cases: rows are scenes, columns are schemes";
  record.requirement =
      "No entry may be a NaN, a hang or a silent wrong answer: it is stable within its bound, or refused for a reason.";
  reports::Table table{"Stability of the hard cases",
                       "Verdicts",
                       "Stable and within its bound, refused for a reason, or FAIL; errors over their bounds. Each "
                       "row's page has the rest.",
                       {"case"},
                       {}};
  if (const reports::Table* entries = rows.empty() ? nullptr : entries_of(rows.front()))
    for (const auto& entry : entries->rows) table.header.push_back(entry.at(0));
  int failed = 0;
  for (const reports::Record& row : rows) {
    failed += add_row(table, row);
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

}  // namespace wetfront::verification
