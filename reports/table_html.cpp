#include "reports/table_html.h"

#include "reports/escape.h"
#include "reports/number_text.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>

namespace wetfront::reports {

namespace {

bool numeric(const std::string& cell) {
  const std::size_t start = cell.rfind("\u2212", 0) == 0 ? 3 : cell.find_first_not_of("+-<>~ ");
  return start < cell.size() && (std::isdigit(static_cast<unsigned char>(cell[start])) || cell == "NaN" || cell == "–");
}

/// A column reads as numbers when most of its filled cells do.
bool numeric_column(const Table& table, std::size_t column) {
  std::size_t filled = 0, numbers = 0;
  for (const auto& row : table.rows)
    if (column < row.size() && !row[column].empty()) {
      ++filled;
      numbers += numeric(row[column]);
    }
  return filled > 0 && 2 * numbers > filled;
}

/// Shares draw a bar behind their number.
std::string share_style(const std::string& header, const std::string& cell) {
  if (header.find('%') == std::string::npos) return "";
  const double share = std::strtod(cell.c_str(), nullptr);
  if (!(share > 0) || share > 100) return "";
  return " style=\"--share:" + number_text(std::max(0.01, share), 4) + "%\" data-share";
}

std::string linked(const std::string& text, const std::string& link) {
  if (link.empty()) return html(text);
  const std::size_t place = std::min(link.size(), link.find('#'));  // what stands behind it is an id, and safe
  return "<a href=\"" + html(url_path(link.substr(0, place)) + link.substr(place)) + "\">" + html(text) + "</a>";
}

const Table::Mark* mark_of(const Table& table, std::size_t row, std::size_t column) {
  if (row >= table.marks.size() || column >= table.marks[row].size() || table.marks[row][column].kind.empty())
    return nullptr;
  return &table.marks[row][column];
}

/// A cell in its colour: the text, or at a glance a sign and a word, the text being its title.
std::string marked(const Table::Mark& mark, const std::string& text, TableForm form) {
  const std::string word = mark.kind == "pass" ? "✓ stable" : mark.kind == "fail" ? "✕ FAIL" : "– refused";
  const bool glance = form == TableForm::glance;
  return "<td class=\"mark " + html(mark.kind) + "\"" + (glance ? " title=\"" + html(text) + "\"" : "") + ">" +
         linked(glance ? word : text, mark.link) + "</td>";
}

/// Long, and read by few: closed until it is asked for.
bool folded(const Table& table) {
  return table.section == "Flux audit" && table.rows.size() > 24;
}

}  // namespace

std::string table_html(const Table& table, TableForm form) {
  std::ostringstream out;
  if (folded(table))
    out << "<details class=\"folded\"><summary>" << html(table.title) << ", " << table.rows.size() << " rows</summary>";
  out << "<div class=\"wide\"><table class=\"plain" << (form == TableForm::glance ? " glance" : "") << "\"><caption><b>"
      << html(table.title) << "</b>";
  if (!table.caption.empty()) out << " <span>" << html(table.caption) << "</span>";
  out << "</caption><thead><tr>";
  std::size_t columns = table.header.size();
  for (const auto& row : table.rows) columns = std::max(columns, row.size());
  std::vector<const char*> kind;
  for (std::size_t c = 0; c < columns; ++c) kind.push_back(numeric_column(table, c) ? " class=\"number\"" : "");
  for (std::size_t c = 0; c < table.header.size(); ++c)
    out << "<th" << kind[c] << ">" << html(table.header[c]) << "</th>";
  out << "</tr></thead><tbody>\n";
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const auto& row = table.rows[r];
    out << "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (const Table::Mark* mark = mark_of(table, r, c)) {
        out << marked(*mark, row[c], form);
        continue;
      }
      out << "<td" << kind[c] << (c < table.header.size() ? share_style(table.header[c], row[c]) : "") << ">"
          << (c == 0 && r < table.links.size() ? linked(row[c], table.links[r]) : html(row[c])) << "</td>";
    }
    out << "</tr>\n";
  }
  out << "</tbody></table></div>" << (folded(table) ? "</details>\n" : "\n");
  return out.str();
}

}  // namespace wetfront::reports
