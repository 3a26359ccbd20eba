#include "reports/verdict_table.h"

#include "reports/escape.h"
#include "reports/number_text.h"
#include "reports/quantity_anchor.h"
#include "reports/record_json.h"
#include "reports/tolerance_bar.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace wetfront::reports {

namespace {

const char* word_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "PASS";
    case Verdict::fail:
      return "FAIL";
    case Verdict::inconclusive:
      return "INCONCLUSIVE";
    case Verdict::info:
      return "INFO";
  }
  return "";
}

const char* sign_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "✓";
    case Verdict::fail:
      return "✕";
    case Verdict::inconclusive:
      return "?";
    case Verdict::info:
      return "i";
  }
  return "";
}

/// A percent sign stays with its number.
std::string unbroken(std::string text) {
  for (std::size_t at = 0; (at = text.find(" %", at)) != std::string::npos;) text.replace(at, 1, "\u00a0");
  return text;
}

/// The bound, and beneath it how the meshes behind it went.
void write_bound(std::ostream& out, const Finding& finding) {
  out << html(quantity_text(finding.reference_bound, finding.unit, 2));
  if (finding.reference_convergence.empty()) return;
  out << "<p class=\"explanation\">" << html(finding.reference_convergence);
  if (!std::isnan(finding.reference_order)) out << ", order " << html(number_text(finding.reference_order));
  out << "</p>";
}

/// A finding and what a row says of it beside its own words.
struct Row {
  const Finding* finding;
  std::string id;     ///< of the first finding of a quantity: where index pages lead
  std::string trend;  ///< through earlier runs
};

void write_row(std::ostream& out, const Row& row) {
  const Finding& finding = *row.finding;
  const bool gated = finding.verdict != Verdict::info;
  out << "<tr class=\"" << verdict_key(finding.verdict) << "\"" << (row.id.empty() ? "" : " id=\"" + row.id + "\"")
      << "><td>" << badge(finding.verdict) << "</td><td class=\"what\">"
      << html(unbroken(finding.description.empty() ? finding.quantity : finding.description)) << "<code>"
      << html(finding.quantity) << "</code>";
  if (!finding.explanation.empty()) out << "<p class=\"explanation\">" << html(finding.explanation) << "</p>";
  out << "</td><td class=\"number\">" << html(quantity_text(finding.error, finding.unit))
      << "</td><td class=\"number\">";
  write_bound(out, finding);
  out << "</td><td class=\"number\">" << (gated ? html(quantity_text(finding.tolerance, finding.unit)) : "–")
      << "</td><td class=\"barcell\">" << tolerance_bar(finding) << (row.trend.empty() ? "" : "<br>") << row.trend
      << "</td><td class=\"number\">" << html(number_text(finding.cpu_s)) << "</td>"
      << "<td class=\"reason\">" << html(finding.reason) << "</td></tr>\n";
}

void write_table(std::ostream& out, const std::string& id, const std::vector<Row>& rows) {
  std::vector<std::string> groups;
  for (const Row& row : rows)
    if (std::find(groups.begin(), groups.end(), row.finding->group) == groups.end())
      groups.push_back(row.finding->group);
  out << "<div class=\"wide\"><table id=\"" << id
      << "\" class=\"verdicts\"><thead><tr><th>Verdict</th><th>Quantity</th>"
         "<th class=\"number\">Error</th><th class=\"number\">Reference bound</th><th class=\"number\">Tolerance</th>"
         "<th>Error / tolerance</th><th class=\"number\">CPU&nbsp;[s]</th>"
      << "<th>Reason for the tolerance</th></tr></thead>\n";
  for (const std::string& group : groups) {
    out << "<tbody>";
    if (!group.empty())
      out << "<tr class=\"group\"><th colspan=\"8\" scope=\"rowgroup\">" << html(group) << "</th></tr>\n";
    for (const Row& row : rows)
      if (row.finding->group == group) write_row(out, row);
    out << "</tbody>\n";
  }
  out << "</table></div>\n";
}

}  // namespace

std::string quantity_anchor(const std::string& quantity) {
  return "quantity-" + anchor(quantity);
}

std::string badge(Verdict verdict) {
  return std::string("<span class=\"badge ") + verdict_key(verdict) + "\"><span aria-hidden=\"true\">" +
         sign_of(verdict) + "</span>\u00a0" + word_of(verdict) + "</span>";
}

std::string verdict_table(const Record& record, const std::vector<PastRun>& past) {
  std::vector<Row> gated, shown;
  std::map<std::string, int> numbers;
  std::set<std::string> ids;
  const auto id_of = [&](const Finding& finding) {
    const std::string id = quantity_anchor(finding.quantity);
    return ids.insert(id).second ? id : "";
  };
  for (const Finding& finding : record.findings) {
    const int number = numbers[finding.quantity]++;
    if (finding.verdict != Verdict::info)
      gated.push_back({&finding, id_of(finding), trend(past, finding.quantity, number, finding.unit)});
  }
  for (const Finding& finding : record.findings)  // quantities that nothing gates
    if (finding.verdict == Verdict::info) shown.push_back({&finding, id_of(finding), ""});
  std::ostringstream out;
  if (!gated.empty()) write_table(out, "verdict-table", gated);
  if (shown.empty()) return out.str();
  // What decides nothing is folded away, so that the figures follow the verdicts; it opens without scripts, too.
  out << "<details class=\"shown-only\"" << (gated.empty() ? " open" : "") << "><summary>" << shown.size()
      << " more shown, not gated</summary>\n";
  write_table(out, "shown-table", shown);
  out << "</details>\n";
  return out.str();
}

std::string verdict_counts(const Record& record) {
  std::string text;
  for (const Verdict verdict : {Verdict::pass, Verdict::fail, Verdict::inconclusive, Verdict::info}) {
    const auto count = std::count_if(record.findings.begin(), record.findings.end(),
                                     [verdict](const Finding& finding) { return finding.verdict == verdict; });
    if (count == 0) continue;
    text += (text.empty() ? "" : " · ") + std::to_string(count) + "\u00a0" + word_of(verdict);
  }
  return text;
}

}  // namespace wetfront::reports
