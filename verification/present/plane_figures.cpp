#include "verification/present/plane_figures.h"

#include "verification/present/contours.h"
#include "verification/present/figure_frame.h"

#include <fmt/format.h>

#include <algorithm>

namespace wetfront::verification {
namespace {

using reports::Figure;

constexpr double kPa = 1000;

Figure ground_figure(const FigureHeading& heading) {
  return figure_frame(heading, {"x", "m"}, {"elevation", "m"});
}

void add(Figure& figure, reports::Series series, const std::string& label, int colour) {
  if (series.x.empty()) return;
  series.label = label;
  series.colour = colour;
  figure.series.push_back(std::move(series));
}

/// Drawn last in one colour, the outline solid and the boundaries of soils dashed.
void add_ground(Figure& figure, const meshes::Mesh& mesh) {
  constexpr int grey = 6;
  add(figure, outline(mesh), "ground", grey);
  reports::Series inner = region_boundaries(mesh);
  inner.style = reports::Series::Style::dashed;
  add(figure, std::move(inner), "boundary of soils", grey);
}

Figure contours_of(const FigureHeading& heading, const meshes::Mesh& mesh, const std::vector<double>& nodal,
                   double unit, const std::string& unit_name) {
  Figure figure = ground_figure(heading);
  const auto [low, high] = std::ranges::minmax(nodal);
  int colour = 0;
  for (const double level : round_levels(low / unit, high / unit, 6))
    add(figure, contour(mesh, nodal, level * unit), fmt::format("{:.4g}{}", level, unit_name), colour++);
  figure.note = fmt::format("from {:.4g}{} to {:.4g}{}", low / unit, unit_name, high / unit, unit_name);
  add_ground(figure, mesh);
  return figure;
}

/// Where the soil is halfway between its driest and its wettest, at each time.
Figure front_figure(const meshes::FieldHistory& history) {
  Figure figure = ground_figure({"wetting_front", "Wetting front", "Profiles"});
  double low = 1, high = 0;
  for (const meshes::Snapshot& snapshot : history.snapshots) {
    const auto [least, most] = std::ranges::minmax(snapshot.node_saturation);
    low = std::min(low, least);
    high = std::max(high, most);
  }
  const double middle = (low + high) / 2;
  int colour = 0;
  for (const meshes::Snapshot& snapshot : history.snapshots)
    add(figure, contour(history.mesh, snapshot.node_saturation, middle), fmt::format("{:.6g} s", snapshot.time),
        colour++);
  figure.note = fmt::format("where the degree of saturation is {:.3g}, halfway between its extremes", middle);
  add_ground(figure, history.mesh);
  return figure;
}

/// Where the pore pressure is zero, at each time; no series where it nowhere is.
Figure water_table_figure(const meshes::FieldHistory& history) {
  Figure figure = ground_figure({"water_table", "Water table: pore pressure zero", "Profiles"});
  int colour = 0;
  for (const meshes::Snapshot& snapshot : history.snapshots)
    add(figure, contour(history.mesh, snapshot.node_pressure, 0), fmt::format("{:.6g} s", snapshot.time), colour++);
  if (!figure.series.empty()) add_ground(figure, history.mesh);
  return figure;
}

}  // namespace

std::vector<Figure> plane_figures(const meshes::FieldHistory& history, const std::string& who) {
  if (history.mesh.dim != 2 || history.snapshots.empty()) return {};
  const meshes::Snapshot& last = history.snapshots.back();
  const std::string when = fmt::format(" of the {} at {:.6g} s", who, last.time);
  std::vector<Figure> pictures = {contours_of({"pressure_contours", "Pore pressure" + when, "Profiles"}, history.mesh,
                                              last.node_pressure, kPa, " kPa"),
                                  contours_of({"saturation_contours", "Degree of saturation" + when, "Profiles"},
                                              history.mesh, last.node_saturation, 1, ""),
                                  front_figure(history), water_table_figure(history)};
  std::erase_if(pictures, [](const Figure& picture) { return picture.series.empty(); });
  return pictures;
}

}  // namespace wetfront::verification
