#include "verification/present/plane_figures.h"

#include "verification/compare/profile.h"
#include "verification/present/contours.h"
#include "verification/present/figure_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

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

/// Halfway between the driest and the wettest of a whole run.
double middle_saturation(const meshes::FieldHistory& history) {
  double low = 1, high = 0;
  for (const meshes::Snapshot& snapshot : history.snapshots)
    for (const double saturation : snapshot.node_saturation) {
      low = std::min(low, saturation);
      high = std::max(high, saturation);
    }
  return (low + high) / 2;
}

/// Where the soil is halfway between its driest and its wettest, at each time.
Figure front_figure(const meshes::FieldHistory& history) {
  Figure figure = ground_figure({"wetting_front", "Wetting front", "Profiles"});
  const double middle = middle_saturation(history);
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

std::vector<std::size_t> all_until(std::size_t count) {
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

std::vector<double> pressure_levels(const meshes::Snapshot& snapshot) {
  const auto [low, high] = std::ranges::minmax(snapshot.node_pressure);
  std::vector<double> levels;
  for (const double level : round_levels(low / kPa, high / kPa, 6)) levels.push_back(level * kPa);
  return levels;
}

/// Which contours a picture of two solutions shows.
struct Contours {
  std::vector<std::size_t> times;
  std::vector<double> levels;
  std::vector<double> meshes::Snapshot::*nodal;
};

Figure both(const FigureHeading& heading, const Histories& histories, const Contours& what) {
  Figure figure = ground_figure(heading);
  int colour = 0;
  for (const std::size_t t : what.times)
    for (const double level : what.levels) {
      const bool in_time = what.times.size() > 1;
      const std::string label = in_time ? fmt::format("{:.6g} s", histories.reference.snapshots[t].time)
                                        : fmt::format("{:.4g} kPa", level / kPa);
      add(figure, contour(histories.reference.mesh, histories.reference.snapshots[t].*what.nodal, level),
          "reference, " + label, colour);
      reports::Series candidate =
          contour(histories.candidate.mesh, histories.candidate.snapshots[t].*what.nodal, level);
      candidate.style = reports::Series::Style::dashed;
      add(figure, std::move(candidate), "MPM, " + label, colour++);
    }
  if (!figure.series.empty()) add_ground(figure, histories.reference.mesh);
  return figure;
}

/// MPM minus reference, on the MPM's mesh.
Figure difference(const meshes::FieldHistory& candidate, const meshes::FieldHistory& reference, std::size_t time,
                  const std::string& when) {
  std::vector<double> nodal =
      values_at_nodes(reference.mesh, {&reference.snapshots[time].node_pressure}, candidate.mesh).front();
  const std::vector<double> compared = node_weights(candidate.mesh, reference.mesh);
  for (std::size_t i = 0; i < nodal.size(); ++i)
    nodal[i] = compared[i] == 0 ? 0 : candidate.snapshots[time].node_pressure[i] - nodal[i];
  return contours_of({"pressure_difference", "Pressure difference" + when + ", MPM minus reference", "Profiles"},
                     candidate.mesh, nodal, 1, " Pa");
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

std::vector<Figure> plane_comparison(const Histories& histories) {
  const meshes::FieldHistory &candidate = histories.candidate, &reference = histories.reference;
  const std::size_t times = std::min(candidate.snapshots.size(), reference.snapshots.size());
  if (candidate.mesh.dim != 2 || reference.mesh.dim != 2 || times == 0) return {};
  const std::string when = fmt::format(" at {:.6g} s", reference.snapshots[times - 1].time);
  std::vector<Figure> pictures = {
      both({"pressure_contours", "Pore pressure" + when + ": reference solid, MPM dashed", "Profiles"}, histories,
           {{times - 1}, pressure_levels(reference.snapshots[times - 1]), &meshes::Snapshot::node_pressure}),
      both({"water_table", "Water table, pore pressure zero: reference solid, MPM dashed", "Profiles"}, histories,
           {all_until(times), {0}, &meshes::Snapshot::node_pressure}),
      both({"wetting_front", "Wetting front: reference solid, MPM dashed", "Profiles"}, histories,
           {all_until(times), {middle_saturation(reference)}, &meshes::Snapshot::node_saturation}),
      difference(candidate, reference, times - 1, when)};
  std::erase_if(pictures, [](const Figure& picture) { return picture.series.empty(); });
  return pictures;
}

}  // namespace wetfront::verification
