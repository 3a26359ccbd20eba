#include "reports/escape.h"
#include "reports/number_text.h"
#include "reports/page.h"
#include "reports/quantity_anchor.h"
#include "reports/record_json.h"
#include "reports/run_history.h"
#include "reports/table_html.h"
#include "reports/tolerance_bar.h"
#include "reports/verdict_table.h"
#include "reports/whole_file.h"
#include "reports/write.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace wetfront::reports {

namespace {

struct Run {
  Record record;
  std::filesystem::path folder;  ///< absolute
  std::string link;
  std::vector<PastRun> past;
};

/// All findings of one quantity in one run: the gravest verdict and the largest error in tolerances.
struct Cell {
  int findings = 0;
  Verdict verdict = Verdict::info;
  double share = 0;
  Finding worst;
  int number = 0;  ///< of the worst among the findings of its quantity
};

int gravity(Verdict verdict) {
  return verdict == Verdict::fail ? 3 : verdict == Verdict::inconclusive ? 2 : verdict == Verdict::pass ? 1 : 0;
}

Cell cell_of(const Record& record, const std::string& quantity) {
  Cell cell;
  int next = 0;
  for (const Finding& finding : record.findings) {
    if (finding.quantity != quantity) continue;
    const int number = next++;
    const double share = tolerance_share(finding);
    if (++cell.findings == 1 || share > cell.share || std::isnan(finding.error)) {
      cell.share = share;
      cell.worst = finding;
      cell.number = number;
    }
    if (gravity(finding.verdict) > gravity(cell.verdict)) cell.verdict = finding.verdict;
  }
  return cell;
}

/// Those that are gated anywhere, what most runs gate first: a reader of many columns sees the first few.
std::vector<std::string> quantities_of(const std::vector<Run>& runs) {
  std::vector<std::string> quantities;
  std::map<std::string, int> gating;  // runs
  for (const Run& run : runs) {
    std::set<std::string> gated;
    for (const Finding& finding : run.record.findings)
      if (finding.verdict != Verdict::info && gated.insert(finding.quantity).second && ++gating[finding.quantity] == 1)
        quantities.push_back(finding.quantity);
  }
  std::stable_sort(quantities.begin(), quantities.end(),
                   [&](const std::string& a, const std::string& b) { return gating[a] > gating[b]; });
  return quantities;
}

/// "pressure_l2" may break after the underscore.
std::string column_title(const std::string& quantity) {
  std::string title = html(quantity);
  for (std::size_t at = 0; (at = title.find('_', at)) != std::string::npos; at += 6) title.replace(at, 1, "_<wbr>");
  return title;
}

/// The cell leads to the first finding of its quantity on the run's own page.
std::string cell_html(const Cell& cell, const Run& run) {
  if (cell.findings == 0) return "<td class=\"none\">–</td>";
  const std::string tip = cell.worst.description + ": error " + quantity_text(cell.worst.error, cell.worst.unit) +
                          ", tolerance " + quantity_text(cell.worst.tolerance, cell.worst.unit);
  const std::string place = cell.verdict == Verdict::info ? "" : "#" + quantity_anchor(cell.worst.quantity);
  std::ostringstream value;
  value << " data-value=\"" << (std::isfinite(cell.share) ? cell.share : -gravity(cell.verdict)) << "\"";
  std::string text = "<td title=\"" + html(tip) + "\"" + value.str() + "><a href=\"" + html(run.link) + place + "\">" +
                     badge(cell.verdict) + "</a>";
  if (cell.verdict != Verdict::info) text += "<div class=\"small\">" + tolerance_bar(cell.worst) + "</div>";
  text += "<span class=\"count\">" + html(quantity_text(cell.worst.error, cell.worst.unit, 2)) + "</span> ";
  if (cell.findings > 1) text += "<span class=\"count\">worst of " + std::to_string(cell.findings) + "</span>";
  const std::string line = trend(run.past, cell.worst.quantity, cell.number, cell.worst.unit);
  return text + (line.empty() ? "" : "<div>" + line + "</div>") + "</td>";
}

/// What the maker of a run may tell of it in its provenance, for columns of their own.
struct Column {
  const char *key, *title;
};
constexpr Column told_columns[] = {{"observed_orders", "Orders"}, {"degrees_of_freedom", "DoF"}};

std::vector<Column> columns_told(const std::vector<Run>& runs) {
  std::vector<Column> told;
  for (const Column& column : told_columns)
    if (std::any_of(runs.begin(), runs.end(),
                    [&](const Run& run) { return run.record.provenance.contains(column.key); }))
      told.push_back(column);
  return told;
}

/// What a run is called: its title, and what kind of study it is of that.
std::string name_of(const Record& record) {
  const std::string name = record.title.empty() ? record.case_name : record.title;
  return record.kind == Record{}.kind ? name : name + ": " + record.kind;
}

std::string matrix(const std::vector<Run>& runs) {
  const std::vector<std::string> quantities = quantities_of(runs);
  std::ostringstream out;
  out << "<div class=\"wide\"><table class=\"matrix\"><thead><tr><th>Case</th><th>Verdict</th>";
  for (const std::string& quantity : quantities) out << "<th><code>" << column_title(quantity) << "</code></th>";
  const std::vector<Column> told = columns_told(runs);
  for (const Column& column : told) out << "<th class=\"number\">" << column.title << "</th>";
  out << "<th class=\"number\">CPU&nbsp;[s]</th></tr></thead><tbody>\n";
  for (const Run& run : runs) {
    out << "<tr data-verdict=\"" << verdict_key(run.record.verdict) << "\"><th scope=\"row\"><a href=\""
        << html(run.link) << "\">" << html(name_of(run.record)) << "</a><code>" << html(run.record.case_name)
        << "</code></th><td data-value=\"" << gravity(run.record.verdict) << "\">" << badge(run.record.verdict)
        << "</td>";
    for (const std::string& quantity : quantities) out << cell_html(cell_of(run.record, quantity), run);
    for (const Column& column : told) {
      const auto value = run.record.provenance.find(column.key);
      out << "<td class=\"number\">" << (value == run.record.provenance.end() ? "–" : html(value->second)) << "</td>";
    }
    out << "<td class=\"number\">" << html(number_text(run.record.cpu_seconds)) << "</td></tr>\n";
  }
  out << "</tbody></table></div>\n";
  return out.str();
}

/// What the head of the page says of all runs.
struct Summary {
  double cpu = 0;
  Record verdicts;  ///< one finding per run

  void add(const Run& run) {
    cpu += run.record.cpu_seconds;
    verdicts.findings.emplace_back().verdict = run.record.verdict;
  }
  std::string text() const {
    return "<p class=\"summary\"><span>" + std::to_string(verdicts.findings.size()) + " runs</span><span>" +
           verdict_counts(verdicts) + "</span><span>" + html(duration_text(cpu)) + " of CPU time</span></p>";
  }
};

std::vector<Run> runs_of(const RunGroup& group, const std::filesystem::path& home) {
  std::vector<Run> runs;
  for (const auto& folder : group.folders) {
    const auto whole = std::filesystem::absolute(folder);
    const auto report = whole / "report.html";
    runs.push_back({read_result(folder / "result.json"), whole,
                    url_path(report.lexically_relative(home).generic_string()), past_runs(folder)});
  }
  return runs;
}

/// Tables with marks, such as the matrix of hard cases, from the runs' own pages; their links lead from this page.
std::string marked_tables(const std::vector<Run>& runs, const std::filesystem::path& home) {
  std::string tables;
  for (const Run& run : runs)
    for (const Table& own : run.record.tables) {
      if (own.marks.empty()) continue;
      Table table = own;
      const auto from_here = [&](std::string& link) {
        if (!link.empty()) link = (run.folder / link).lexically_normal().lexically_relative(home).generic_string();
      };
      for (std::string& link : table.links) from_here(link);
      for (auto& row : table.marks)
        for (Table::Mark& mark : row) from_here(mark.link);
      tables += table_html(table, TableForm::glance);
    }
  return tables;
}

}  // namespace

void write_index(const std::vector<std::filesystem::path>& run_folders, const std::filesystem::path& page,
                 const std::string& title) {
  write_index(std::vector<RunGroup>{{"", run_folders}}, page, title);
}

void write_index(const std::vector<RunGroup>& groups, const std::filesystem::path& page, const std::string& title) {
  const std::filesystem::path home = std::filesystem::absolute(page).parent_path();
  make_folder(home);
  Summary summary;
  std::string sections;
  for (const RunGroup& group : groups) {
    const std::vector<Run> runs = runs_of(group, home);
    sections += "<section>\n" + (group.title.empty() ? "" : "<h2>" + html(group.title) + "</h2>\n") +
                marked_tables(runs, home) + matrix(runs) + "</section>\n";
    for (const Run& run : runs) summary.add(run);
  }
  const std::string body = "<div class=\"overview\"><header><p class=\"kind\">wetfront · overview</p><h1>" +
                           html(title) + "</h1>" + summary.text() + "</header>\n<main>\n" + sections +
                           "<p class=\"hint\">Each cell holds the gravest verdict and the largest error of one "
                           "quantity, as a share of its tolerance (the upright line); the whisker is the reference’s "
                           "own uncertainty. A case’s name and "
                           "its cells lead to its report; small lines are the last runs, the grey line the tolerance. "
                           "Quantities that most runs gate stand first; a shade at a table's "
                           "right edge says that it goes on there.</p></main></div>\n";
  write_whole(page, whole_page(title + " · wetfront", body));
}

}  // namespace wetfront::reports
