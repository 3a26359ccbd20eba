#include "reports/figure_script.h"

#include "reports/csv.h"
#include "reports/escape.h"
#include "reports/number_text.h"
#include "reports/palette.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace wetfront::reports {

namespace {

// Pixels. Text widths are estimated: a proportional font of size s takes about 0.55 s per character.
constexpr double title_line = 20, note_line = 17, axis_strip = 56, legend_line = 19, sample = 30, gap = 9;
constexpr double ink_size = 12, character = 0.5 * ink_size, label_character = 6;

std::vector<std::string> lines_of(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  std::istringstream wrapped(wrap(text, width));
  for (std::string line; std::getline(wrapped, line);) lines.push_back(line);
  return lines;
}

/// gnuplot's `screen` coordinates of a pixel.
std::string at(const FigureLayout& layout, double x, double y) {
  return "screen " + exact_text(x / FigureLayout::width) + "," + exact_text(1 - y / layout.height);
}

void write_frame(std::ostream& out, const Figure& figure, const FigureLayout& layout) {
  out << "reset\nset encoding utf8\nset datafile separator comma\nset minussign\n"
      << "set terminal svg size " << FigureLayout::width << "," << layout.height
      << " dynamic noenhanced font 'Helvetica,12' background '#ffffff'\n"
      << "set output " << gnuplot_string(figure.id + ".svg") << "\n"
      << "set lmargin at screen " << exact_text(FigureLayout::left / FigureLayout::width) << "\n"
      << "set rmargin at screen " << exact_text(layout.right() / FigureLayout::width) << "\n"
      << "set tmargin at screen " << exact_text(1 - layout.top / layout.height) << "\n"
      << "set bmargin at screen " << exact_text(1 - layout.bottom() / layout.height) << "\n"
      << "set border 3 linecolor rgb '#555555'\nset tics out nomirror scale 0.6,0.35 textcolor rgb '#333333'\n"
      << "set grid xtics ytics linetype 1 linecolor rgb '#e8e8e8' linewidth 0.8\nunset key\n";
}

void write_axis(std::ostream& out, const std::string& name, const Axis& axis, const std::string& label) {
  out << "set " << name << "range [" << exact_text(axis.from) << ":" << exact_text(axis.to) << "] noextend\n";
  if (axis.log) out << "set logscale " << name << "\n";
  out << "set " << name << "tics (";
  for (std::size_t i = 0; i < axis.ticks.size(); ++i)
    out << (i ? ", " : "") << gnuplot_string(axis.ticks[i].label) << " " << exact_text(axis.ticks[i].at)
        << (axis.ticks[i].label.empty() ? " 1" : " 0");
  out << ")\nset " << name << "label " << gnuplot_string(label) << " textcolor rgb '#222222'\n";
}

void write_texts(std::ostream& out, const FigureLayout& layout) {
  double y = 16;
  for (const std::string& line : layout.title_lines) {
    out << "set label " << gnuplot_string(line) << " at " << at(layout, 12, y)
        << " left font 'Helvetica:Bold,14' textcolor rgb '#1a1a1a'\n";
    y += title_line;
  }
  for (const std::string& line : layout.note_lines) {
    out << "set label " << gnuplot_string(line) << " at " << at(layout, 12, y)
        << " left font 'Helvetica,12' textcolor rgb '#5a5a5a'\n";
    y += note_line;
  }
}

/// Shaded windows lie behind the data, their labels above the plot, so that they cover nothing.
void write_windows(std::ostream& out, const Figure& figure, const FigureLayout& layout, const Axis& x) {
  for (const Figure::Window& window : figure.shaded) {
    const double from = std::max(window.from, x.from), to = std::min(window.to, x.to);
    if (!(from < to)) continue;
    out << "set object rectangle from " << exact_text(from) << ", graph 0 to " << exact_text(to)
        << ", graph 1 behind fillcolor rgb '#f1ece0' fillstyle solid noborder\n";
    const double share = x.log ? std::log(from / x.from) / std::log(x.to / x.from) : (from - x.from) / (x.to - x.from);
    // A label that would not fit between its window's beginning and the picture's edge ends at the edge instead.
    const double left = FigureLayout::left + share * FigureLayout::plot_width + 2, edge = FigureLayout::width - 4;
    const bool fits = left + label_character * static_cast<double>(characters(window.label)) <= edge;
    out << "set label " << gnuplot_string(window.label) << " at " << at(layout, fits ? left : edge, layout.top - 8)
        << (fits ? " left" : " right") << " font 'Helvetica,11' textcolor rgb '#7a6a45'\n";
  }
}

std::string line_style(const Series& series, int index) {
  return std::string("linewidth 1.8 dashtype ") + (series.style == Series::Style::dashed ? "(7,4)" : "solid") +
         " linecolor rgb '" + colour_of(index) + "'";
}

std::string point_style(int index) {
  return "pointtype " + std::to_string(mark_of(index)) + " pointsize 0.7 linewidth 1.4 linecolor rgb '" +
         colour_of(index) + "'";
}

/// Drawn by hand below the plot: gnuplot's own key reserves widths for a font it does not have. A series without a
/// label has no entry.
void write_legend(std::ostream& out, const Figure& figure, const FigureLayout& layout) {
  const std::vector<int> indices = palette_indices(figure);
  const double column = FigureLayout::plot_width / static_cast<double>(layout.legend_columns);
  std::size_t entry = 0;
  for (std::size_t s = 0; s < figure.series.size(); ++s) {
    const Series& series = figure.series[s];
    if (series.label.empty()) continue;
    const double x = FigureLayout::left + column * static_cast<double>(entry % layout.legend_columns);
    const double y =
        layout.bottom() + axis_strip + legend_line * static_cast<double>(entry / layout.legend_columns) + 4;
    ++entry;
    if (series.style == Series::Style::points)
      out << "set label '' at " << at(layout, x + sample / 2 - 3, y) << " point " << point_style(indices[s]) << "\n";
    else
      out << "set arrow from " << at(layout, x, y) << " to " << at(layout, x + sample - 6, y) << " nohead "
          << line_style(series, indices[s]) << "\n";
    out << "set label " << gnuplot_string(series.label) << " at " << at(layout, x + sample, y)
        << " left textcolor rgb '#222222'\n";
  }
}

/// Lines first, then points, so that the candidate's points lie over the reference's line.
void write_plot(std::ostream& out, const Figure& figure) {
  const std::vector<int> indices = palette_indices(figure);
  std::string separator = "plot ";
  for (const bool points : {false, true}) {
    for (std::size_t s = 0; s < figure.series.size(); ++s) {
      const Series& series = figure.series[s];
      if ((series.style == Series::Style::points) != points) continue;
      if (undrawable_points(figure, series) == series.x.size()) continue;
      out << separator << gnuplot_string(figure.id + ".csv") << " every ::1 using " << 2 * s + 1 << ":" << 2 * s + 2
          << " with " << (points ? "points " + point_style(indices[s]) : "lines " + line_style(series, indices[s]))
          << " title " << gnuplot_string(series.label);
      separator = ", \\\n  ";
    }
  }
  if (separator == "plot ") out << "plot NaN notitle";
  out << "\nunset output\n";
}

}  // namespace

FigureLayout lay_out(const Figure& figure) {
  FigureLayout layout;
  layout.title_lines = lines_of(figure.title, 62);
  layout.note_lines = lines_of(figure.note, 80);
  std::size_t longest = 1, entries = 0;
  for (const Series& series : figure.series) {
    longest = std::max(longest, characters(series.label));
    entries += series.label.empty() ? 0 : 1;
  }
  const double column = sample + gap + character * static_cast<double>(longest);
  layout.legend_columns = std::clamp<std::size_t>(static_cast<std::size_t>(FigureLayout::plot_width / column), 1, 4);
  // Reference and candidate come in pairs, which three columns would tear apart.
  if (layout.legend_columns == 3 && entries % 2 == 0) layout.legend_columns = 2;
  layout.legend_rows = (entries + layout.legend_columns - 1) / layout.legend_columns;
  layout.top = 8 + title_line * static_cast<double>(layout.title_lines.size()) +
               note_line * static_cast<double>(layout.note_lines.size()) + (figure.shaded.empty() ? 10 : 20);
  layout.height = std::ceil(layout.bottom() + axis_strip + legend_line * static_cast<double>(layout.legend_rows) + 2);
  return layout;
}

std::string figure_script(const Figure& figure, const FigureAxes& axes) {
  const FigureLayout layout = lay_out(figure);
  std::ostringstream out;
  out << "# Draws " << wrap(figure.id, 100) << ".svg from " << figure.id << ".csv: gnuplot " << figure.id << ".gp\n";
  write_frame(out, figure, layout);
  write_axis(out, "x", axes.x, label_with_unit(figure.x_label, figure.x_unit));
  write_axis(out, "y", axes.y, "");
  out << "set xlabel offset 0,0.75\nset xtics offset 0,0.3\n";
  // By hand: gnuplot moves its own label out of the picture when the numbers are wide.
  out << "set label " << gnuplot_string(label_with_unit(figure.y_label, figure.y_unit)) << " at "
      << at(layout, 14, (layout.top + layout.bottom()) / 2) << " center rotate by 90 textcolor rgb '#222222'\n";
  write_texts(out, layout);
  write_windows(out, figure, layout, axes.x);
  write_legend(out, figure, layout);
  write_plot(out, figure);
  return out.str();
}

}  // namespace wetfront::reports
