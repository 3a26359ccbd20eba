#include "reports/figures.h"

#include "reports/csv.h"
#include "reports/escape.h"
#include "reports/figure_script.h"
#include "reports/gnuplot.h"
#include "reports/thinned.h"
#include "reports/whole_file.h"

#include <set>
#include <stdexcept>

namespace wetfront::reports {

namespace {

void check(const std::vector<Figure>& figures) {
  std::set<std::string> seen;
  for (const Figure& figure : figures) {
    if (!is_stem(figure.id))
      throw std::runtime_error("figure id '" + figure.id + "' is not a file name stem (letters, digits, _ and -)");
    if (!seen.insert(figure.id).second)
      throw std::runtime_error("figure id '" + figure.id + "' is used twice (its files would overwrite each other)");
    for (const Series& series : figure.series)
      if (series.x.size() != series.y.size())
        throw std::runtime_error("figure '" + figure.id + "': series '" + series.label + "' has " +
                                 std::to_string(series.x.size()) + " x and " + std::to_string(series.y.size()) +
                                 " y values");
  }
}

void replace_all(std::string& text, const std::string& old, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += with.size())
    text.replace(at, old.size(), with);
}

void remove_elements(std::string& text, const std::string& name) {
  const std::string closing = "</" + name + ">";
  for (std::size_t at = 0; (at = text.find("<" + name + ">", at)) != std::string::npos;)
    text.erase(at, text.find(closing, at) + closing.size() - at);
}

/// From gnuplot's file to an element of the page: no prologue and namespaces, ids made unique, tooltips of the plot
/// groups removed, a label for who cannot see it. Marks get a white inside and a stronger outline than gnuplot's, so
/// that they stand out from the line they lie on.
std::string inline_svg(std::string svg, const Figure& figure) {
  const std::size_t start = svg.find("<svg");
  if (start == std::string::npos) throw std::runtime_error("gnuplot: wrote no SVG for figure '" + figure.id + "'");
  svg.erase(0, start);
  remove_elements(svg, "title");
  remove_elements(svg, "desc");
  replace_all(svg, "xmlns=\"http://www.w3.org/2000/svg\"", "");
  replace_all(svg, "xmlns:xlink=\"http://www.w3.org/1999/xlink\"", "");
  replace_all(svg, "xlink:href", "href");
  for (const std::string name : {"gp", "gnuplot_", "textbox", "greybox"})
    for (const std::string place : {"id='", "href='#", "id=\""})
      replace_all(svg, place + name, place + figure.id + "_" + name);
  for (const std::string mark : {"gpPt3'", "gpPt5'", "gpPt7'"})
    replace_all(svg, "id='" + figure.id + "_" + mark, "id='" + figure.id + "_" + mark + " fill='#fff'");
  replace_all(svg, "stroke-width='0.222'", "stroke-width='0.4'");
  const std::string label = figure.title + (figure.note.empty() ? "" : ". " + figure.note);
  return svg.replace(0, 4, "<svg role=\"img\" aria-label=\"" + html(label) + "\"");
}

}  // namespace

std::vector<DrawnFigure> write_figures(const std::vector<Figure>& figures, const std::filesystem::path& folder) {
  check(figures);
  if (figures.empty()) return {};
  make_folder(folder);
  const TemporaryFolder desk;
  const std::vector<FigureAxes> axes = choose_axes(figures);
  std::vector<std::filesystem::path> scripts;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::string csv = figure_csv(figures[i]), script = figure_script(figures[i], axes[i]);
    write_whole(folder / (figures[i].id + ".csv"), csv);
    write_whole(folder / (figures[i].id + ".gp"), script);
    write_whole(desk.path() / (figures[i].id + ".csv"), figure_csv(thinned(figures[i])));
    write_whole(desk.path() / (figures[i].id + ".gp"), script);
    scripts.push_back(figures[i].id + ".gp");
  }
  run_gnuplot(scripts, desk.path());
  std::vector<DrawnFigure> drawn;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::string svg = read_whole(desk.path() / (figures[i].id + ".svg"));
    write_whole(folder / (figures[i].id + ".svg"), svg);
    drawn.push_back({axes[i], inline_svg(svg, figures[i])});
  }
  return drawn;
}

}  // namespace wetfront::reports
