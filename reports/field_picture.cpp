#include "reports/field_picture.h"

#include "reports/colour_bands.h"
#include "reports/escape.h"
#include "reports/figure_files.h"
#include "reports/number_text.h"
#include "reports/panel_row.h"
#include "reports/plane_drawing.h"
#include "reports/whole_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace wetfront::reports {

namespace {

constexpr double panel_width = 380;

struct Corner {
  double x, y, value;
};
using Polygon = std::vector<Corner>;

/// The part of a polygon where sign * (value - limit) >= 0; values run straight along edges (Sutherland & Hodgman
/// 1974).
Polygon clipped(const Polygon& whole, double limit, double sign) {
  Polygon part;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const Corner &a = whole[i], &b = whole[(i + 1) % whole.size()];
    const double da = sign * (a.value - limit), db = sign * (b.value - limit);
    if (da >= 0) part.push_back(a);
    if ((da >= 0) == (db >= 0)) continue;
    const double s = da / (da - db);
    part.push_back({a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), limit});
  }
  return part;
}

void draw(std::string& path, const Polygon& polygon, const PlaneDrawing& plane) {
  if (polygon.size() < 3) return;
  long x = 0, y = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const long to_x = plane.x(polygon[i].x), to_y = plane.y(polygon[i].y);
    path += i == 0 ? 'M' : i == 1 ? 'l' : ' ';
    path += std::to_string(i == 0 ? to_x : to_x - x);
    path += ' ';
    path += std::to_string(i == 0 ? to_y : to_y - y);
    x = to_x;
    y = to_y;
  }
  path += 'z';
}

/// One path per band of colour.
std::string painted(const FieldPicture& picture, const std::vector<double>& nodal, const ColourBands& bands,
                    const PlaneDrawing& plane) {
  std::vector<std::string> paths(bands.colours.size());
  for (std::size_t c = 0; c + 3 < picture.cells.size(); c += 4) {
    Polygon cell;
    for (std::size_t k = c; k < c + 4; ++k) {
      const auto node = static_cast<std::size_t>(picture.cells[k]);
      cell.push_back({picture.x[node], picture.y[node], nodal[node]});
    }
    if (std::ranges::any_of(cell, [](const Corner& corner) { return !std::isfinite(corner.value); })) continue;
    const auto [low, high] = std::ranges::minmax(cell, {}, &Corner::value);
    const std::size_t first = bands.band_of(low.value), last = bands.band_of(high.value);
    for (std::size_t band = first; band <= last; ++band) {
      Polygon part = cell;
      if (band > first) part = clipped(part, bands.limits[band], 1);
      if (band < last) part = clipped(part, bands.limits[band + 1], -1);
      draw(paths[band], part, plane);
    }
  }
  std::string out;
  for (std::size_t band = 0; band < paths.size(); ++band)
    if (!paths[band].empty())  // a hair of stroke closes the seams between polygons
      out += "<path fill=\"" + bands.colours[band] + "\" stroke=\"" + bands.colours[band] +
             "\" stroke-width=\"4\" d=\"" + paths[band] + "\"/>\n";
  return out;
}

/// Bands of what all panels share, and of the differences.
std::array<ColourBands, 2> scales(const FieldPicture& picture) {
  std::array<double, 2> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const FieldPicture::Panel& panel : picture.panels)
    for (const double value : panel.nodal)
      if (std::isfinite(value)) {
        low[panel.difference] = std::min(low[panel.difference], value);
        high[panel.difference] = std::max(high[panel.difference], value);
      }
  return {colour_bands(low[0], high[0], false), colour_bands(low[1], high[1], true)};
}

PlaneDrawing plane_of(const FieldPicture& picture) {
  Extent extent = Extent::nothing();
  for (std::size_t i = 0; i < picture.x.size(); ++i) extent.include(picture.x[i], picture.y[i]);
  return {extent, panel_width};
}

std::string range_text(const FieldPicture& picture, const FieldPicture::Panel& panel) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const double value : panel.nodal)
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  if (low > high) return "";
  const std::string unit = picture.unit == "1" || picture.unit == "-" ? "" : "\u00a0" + picture.unit;
  return number_text(low) + " to " + number_text(high) + unit;
}

LegendText legend_of(const FieldPicture& picture, const FieldPicture::Panel& panel, double pressure_per_head) {
  return {panel.difference ? "difference of " + picture.quantity : picture.quantity, picture.unit, pressure_per_head};
}

std::vector<RowPanel> drawn(const FieldPicture& picture, double pressure_per_head) {
  const auto bands = scales(picture);
  const PlaneDrawing plane = plane_of(picture);
  std::vector<RowPanel> panels;
  for (const FieldPicture::Panel& panel : picture.panels) {
    const ColourBands& scale = bands[panel.difference];
    panels.push_back({panel.label,
                      plane.open(picture.title + ": " + panel.label) + painted(picture, panel.nodal, scale, plane) +
                          plane.frame() + "</svg>",
                      legend_svg(scale, legend_of(picture, panel, pressure_per_head), panel_width)});
  }
  return panels;
}

}  // namespace

void check(const FieldPicture& picture) {
  const auto wrong = [&](const std::string& why) { throw std::runtime_error("picture '" + picture.id + "': " + why); };
  if (!is_stem(picture.id)) wrong("the id is not a file name stem");
  if (picture.y.size() != picture.x.size()) wrong("x and y differ in length");
  if (picture.cells.size() % 4 != 0) wrong("cells have four nodes each");
  for (const int node : picture.cells)
    if (node < 0 || static_cast<std::size_t>(node) >= picture.x.size())
      wrong("a cell names a node that does not exist");
  for (const FieldPicture::Panel& panel : picture.panels)
    if (panel.nodal.size() != picture.x.size()) wrong("'" + panel.label + "' has not one value per node");
}

std::string picture_html(const FieldPicture& picture, double pressure_per_head) {
  std::ostringstream out;
  out << "<figure class=\"pictures\" id=\"picture-" << html(picture.id) << "\"><figcaption><b>" << html(picture.title)
      << "</b></figcaption><div class=\"panels\">";
  const auto panels = drawn(picture, pressure_per_head);
  for (std::size_t i = 0; i < panels.size(); ++i)
    out << "<div class=\"panel\"><p>" << html(panels[i].label) << " <span>"
        << html(range_text(picture, picture.panels[i])) << "</span></p>" << panels[i].drawing << "\n"
        << panels[i].legend << "</div>\n";
  out << "</div>" << figure_files(picture.id, {{"CSV", ".csv"}, {"SVG", ".svg"}}) << "</figure>\n";
  return out.str();
}

void write_picture(const FieldPicture& picture, const std::filesystem::path& folder) {
  std::ostringstream csv;
  csv << "x [m],y [m]";
  for (const FieldPicture::Panel& panel : picture.panels)
    csv << "," << csv_cell(panel.label + ": " + picture.quantity + " [" + picture.unit + "]");
  csv << "\n";
  for (std::size_t i = 0; i < picture.x.size(); ++i) {
    csv << exact_text(picture.x[i]) << "," << exact_text(picture.y[i]);
    for (const FieldPicture::Panel& panel : picture.panels) csv << "," << exact_text(panel.nodal[i]);
    csv << "\n";
  }
  make_folder(folder);
  write_whole(folder / (picture.id + ".svg"),
              in_a_row(drawn(picture, 0), panel_width, plane_of(picture).height() / 10));
  write_whole(folder / (picture.id + ".csv"), csv.str());
}

}  // namespace wetfront::reports
