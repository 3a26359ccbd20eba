#include "reports/page.h"

#include "reports/escape.h"
#include "reports/figure_data.h"
#include "reports/number_text.h"
#include "reports/page_assets.h"
#include "reports/thinned.h"
#include "reports/verdict_table.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>

namespace wetfront::reports {

namespace {

/// The page's sections in order. Those of figures and tables that are not named here stand before "Cost".
std::vector<std::string> section_order(const Record& record) {
  std::vector<std::string> order = {"The slide", "Profiles", "Time series", "Flux audit"};
  const std::vector<std::string> last = {"Cost", "Effects plan", "Set-up", "Log", "Scene", "Provenance"};
  const auto add = [&](const std::string& section) {
    const bool known = std::count(order.begin(), order.end(), section) || std::count(last.begin(), last.end(), section);
    if (!known && section != "Verdicts") order.push_back(section);
  };
  for (const Figure& figure : record.figures) add(figure.section);
  for (const Table& table : record.tables) add(table.section);
  order.insert(order.end(), last.begin(), last.end());
  return order;
}

std::string anchor(const std::string& section) {
  std::string name = "section-";
  for (const char c : section)
    name += std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::tolower(static_cast<unsigned char>(c)))
                                                        : '-';
  return name;
}

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
  return link.empty() ? html(text) : "<a href=\"" + html(url_path(link)) + "\">" + html(text) + "</a>";
}

std::string table_html(const Table& table) {
  std::ostringstream out;
  out << "<div class=\"wide\"><table class=\"plain\"><caption><b>" << html(table.title) << "</b>";
  if (!table.caption.empty()) out << " <span>" << html(table.caption) << "</span>";
  out << "</caption><thead><tr>";
  const auto kind = [&](std::size_t column) { return numeric_column(table, column) ? " class=\"number\"" : ""; };
  for (std::size_t c = 0; c < table.header.size(); ++c)
    out << "<th" << kind(c) << ">" << html(table.header[c]) << "</th>";
  out << "</tr></thead><tbody>\n";
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const auto& row = table.rows[r];
    out << "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c)
      out << "<td" << kind(c) << (c < table.header.size() ? share_style(table.header[c], row[c]) : "") << ">"
          << (c == 0 && r < table.links.size() ? linked(row[c], table.links[r]) : html(row[c])) << "</td>";
    out << "</tr>\n";
  }
  out << "</tbody></table></div>\n";
  return out.str();
}

std::string figure_html(const Figure& figure, const DrawnFigure& drawn) {
  std::size_t left_out = 0;
  bool thin = false;
  for (const Series& series : figure.series) {
    left_out += undrawable_points(figure, series);
    thin = thin || series.x.size() > drawn_limit;
  }
  std::ostringstream out;
  out << "<figure id=\"figure-" << html(figure.id) << "\">" << drawn.svg << "<script type=\"application/json\">"
      << figure_data(figure, drawn.axes) << "</script>";
  if (left_out > 0)
    out << "<figcaption>" << left_out << " value" << (left_out > 1 ? "s" : "")
        << " not drawn: not finite, or not positive on a logarithmic axis.</figcaption>";
  if (thin)
    out << "<figcaption>Drawn from the outline of its values: series hold more than " << drawn_limit
        << "; the CSV file has them all.</figcaption>";
  out << "</figure>\n";
  return out.str();
}

std::string text_block(const std::string& text) {
  return text.empty() ? "" : "<pre>" + html(text) + "</pre>\n";
}

std::string provenance_list(const Record& record) {
  std::ostringstream out;
  out << "<dl class=\"provenance\">";
  for (const auto& [key, value] : record.provenance)
    out << "<div><dt>" << html(key) << "</dt><dd>" << html(value) << "</dd></div>";
  out << "</dl>\n";
  return record.provenance.empty() ? "" : out.str();
}

/// What a section holds besides its figures and tables.
std::string own_content(const Record& record, const std::string& section) {
  if (section == "Effects plan") return text_block(record.plan_text);
  if (section == "Scene" && !record.scene_text.empty())
    return "<p class=\"path\">" + html(record.scene_path) + "</p>" + text_block(record.scene_text);
  if (section == "Provenance") return provenance_list(record);
  if (section != "Log") return "";
  std::string text;
  for (const std::string& line : record.log) text += line + "\n";
  return text_block(text);
}

std::string section_content(const Record& record, const std::vector<DrawnFigure>& drawn, const std::string& section) {
  std::string figures, tables;
  for (std::size_t i = 0; i < record.figures.size(); ++i)
    if (record.figures[i].section == section) figures += figure_html(record.figures[i], drawn[i]);
  for (const Table& table : record.tables)
    if (table.section == section) tables += table_html(table);
  if (!figures.empty()) figures = "<div class=\"figures\">" + figures + "</div>\n";
  return figures + tables + own_content(record, section);
}

std::string header_html(const Record& record) {
  std::ostringstream out;
  out << "<header><p class=\"kind\">wetfront · " << html(record.kind) << "</p><h1>"
      << html(record.title.empty() ? record.case_name : record.title) << "</h1><p class=\"summary\">"
      << badge(record.verdict) << "<span>" << verdict_counts(record) << "</span><span>"
      << html(duration_text(record.cpu_seconds)) << " of CPU time</span><span>case <b>" << html(record.case_name)
      << "</b></span>";
  for (const char* key : {"git_hash", "date"})
    if (const auto entry = record.provenance.find(key); entry != record.provenance.end())
      out << "<span>"
          << (key == std::string("git_hash") ? "commit " + html(entry->second.substr(0, 12)) : html(entry->second))
          << "</span>";
  out << "</p>";
  if (!record.requirement.empty()) out << "<p class=\"requirement\">" << html(record.requirement) << "</p>";
  out << "</header>\n";
  return out.str();
}

constexpr const char* how_to_read =
    "<p class=\"hint\">PASS: error + reference bound ≤ tolerance. FAIL: error − reference bound &gt; tolerance. "
    "Otherwise INCONCLUSIVE. In the bars the upright line is the tolerance, the whisker the reference’s own "
    "uncertainty.</p>\n";

}  // namespace

std::string whole_page(const std::string& title, const std::string& body) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
         "content=\"width=device-width, initial-scale=1\"><link rel=\"icon\" href=\"data:,\"><title>" +
         html(title) + "</title>\n<style>\n" + page_css + "</style></head>\n<body>\n" + body + "<script>\n" + page_js +
         "</script>\n</body></html>\n";
}

std::string report_page(const Record& record, const std::vector<DrawnFigure>& drawn) {
  std::string navigation = "<nav><a href=\"#section-verdicts\">Verdicts</a>";
  std::string sections = "<section id=\"section-verdicts\"><h2>Verdicts</h2>\n" + verdict_table(record) +
                         (record.findings.empty() ? "" : how_to_read) + section_content(record, drawn, "Verdicts") +
                         "</section>\n";
  for (const std::string& section : section_order(record)) {
    const std::string content = section_content(record, drawn, section);
    if (content.empty()) continue;
    navigation += "<a href=\"#" + anchor(section) + "\">" + html(section) + "</a>";
    sections += "<section id=\"" + anchor(section) + "\"><h2>" + html(section) + "</h2>\n" + content + "</section>\n";
  }
  return whole_page(record.title + " · wetfront",
                    header_html(record) + navigation + "</nav>\n<main>\n" + sections + "</main>\n");
}

}  // namespace wetfront::reports
