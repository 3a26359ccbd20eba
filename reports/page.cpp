#include "reports/page.h"

#include "reports/escape.h"
#include "reports/field_picture.h"
#include "reports/figure_data.h"
#include "reports/figure_files.h"
#include "reports/film_page.h"
#include "reports/number_text.h"
#include "reports/page_assets.h"
#include "reports/table_html.h"
#include "reports/thinned.h"
#include "reports/verdict_table.h"

#include <algorithm>
#include <sstream>

namespace wetfront::reports {

namespace {

/// The page's sections in order. Those of figures and tables that are not named here stand before "Cost".
std::vector<std::string> section_order(const Record& record) {
  std::vector<std::string> order = {"The slide", "Fields", "Profiles", "Time series", "Flux audit"};
  const std::vector<std::string> last = {"Cost", "Effects plan", "Set-up", "Log", "Scene", "Provenance"};
  const auto add = [&](const std::string& section) {
    const bool known = std::count(order.begin(), order.end(), section) || std::count(last.begin(), last.end(), section);
    if (!known && section != "Verdicts") order.push_back(section);
  };
  for (const Figure& figure : record.figures) add(figure.section);
  for (const FieldPicture& picture : record.pictures) add(picture.section);
  for (const Table& table : record.tables) add(table.section);
  order.insert(order.end(), last.begin(), last.end());
  return order;
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
  out << figure_files(figure.id, {{"CSV", ".csv"}, {"SVG", ".svg"}, {"gnuplot", ".gp"}}) << "</figure>\n";
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
  std::string figures, pictures, tables;
  for (std::size_t i = 0; i < record.figures.size(); ++i)
    if (record.figures[i].section == section) figures += figure_html(record.figures[i], drawn[i]);
  for (const FieldPicture& picture : record.pictures)
    if (picture.section == section) pictures += picture_html(picture, record.pressure_per_head);
  for (const Table& table : record.tables)
    if (table.section == section) tables += table_html(table, TableForm::whole);
  if (!figures.empty()) figures = "<div class=\"figures\">" + figures + "</div>\n";
  return pictures + figures + tables + own_content(record, section);
}

/// Bodies that move come first: what happened is seen before it is judged in detail.
std::string films_html(const Record& record) {
  std::string films;
  for (const Film& film : record.films) films += film_html(film, record.pressure_per_head);
  return films.empty() ? "" : "<section id=\"section-motion\"><h2>Motion</h2>\n" + films + "</section>\n";
}

bool shows_pressure(const Record& record) {
  const auto kPa = [](const auto& what) { return what.unit == "kPa"; };
  return std::any_of(record.pictures.begin(), record.pictures.end(), kPa) ||
         std::any_of(record.films.begin(), record.films.end(),
                     [&](const Film& film) { return std::any_of(film.channels.begin(), film.channels.end(), kPa); }) ||
         std::any_of(record.figures.begin(), record.figures.end(),
                     [](const Figure& figure) { return figure.x_unit == "kPa" || figure.y_unit == "kPa"; });
}

/// kPa or metres of water: the style sheet follows the choice, so that it works without scripts, too; page.js takes the
/// line figures along.
std::string unit_switch(const Record& record) {
  if (!(record.pressure_per_head > 0) || !shows_pressure(record)) return "";
  return "<p class=\"units\" data-kpa-per-metre=\"" + exact_text(record.pressure_per_head) +
         "\">pressure in <label><input type=\"radio\" name=\"unit\" id=\"in-kpa\" checked> kPa</label> "
         "<label><input type=\"radio\" name=\"unit\" id=\"in-metres\"> m of water</label></p>";
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
  out << unit_switch(record) << "</header>\n";
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

std::string report_page(const Record& record, const std::vector<DrawnFigure>& drawn, const std::vector<PastRun>& past) {
  const std::string films = films_html(record);
  std::string navigation = std::string("<nav>") + (films.empty() ? "" : "<a href=\"#section-motion\">Motion</a>");
  std::string sections = films;
  const auto add = [&](const std::string& section, const std::string& content) {
    if (content.empty()) return;
    navigation += "<a href=\"#section-" + anchor(section) + "\">" + html(section) + "</a>";
    sections +=
        "<section id=\"section-" + anchor(section) + "\"><h2>" + html(section) + "</h2>\n" + content + "</section>\n";
  };
  add("Verdicts", verdict_table(record, past) + (record.findings.empty() ? "" : how_to_read) +
                      section_content(record, drawn, "Verdicts"));
  for (const std::string& section : section_order(record)) add(section, section_content(record, drawn, section));
  return whole_page(record.title + " · wetfront",
                    header_html(record) + navigation + "</nav>\n<main>\n" + sections + "</main>\n");
}

}  // namespace wetfront::reports
