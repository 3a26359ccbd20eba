#include "verification/present/body_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

using reports::Figure;
using reports::Series;

/// Side of a square with the area of the mean cell.
double cell_size(const meshes::Mesh& mesh) {
  double area = 0;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) area += mesh.cell_measure(c);
  return std::sqrt(area / static_cast<double>(mesh.cell_count()));
}

/// The highest point over each stretch of x one cell wide; broken where there is none.
Series outline_of(const std::vector<meshes::Point>& points, double width) {
  const auto [left, right] = std::ranges::minmax_element(points, {}, [](const meshes::Point& x) { return x[0]; });
  const auto stretches = static_cast<std::size_t>(((*right)[0] - (*left)[0]) / width) + 1;
  std::vector<double> highest(stretches, std::numeric_limits<double>::quiet_NaN());
  for (const meshes::Point& x : points) {
    double& top = highest[std::min(stretches - 1, static_cast<std::size_t>((x[0] - (*left)[0]) / width))];
    if (!(top >= x[1])) top = x[1];
  }
  Series series;
  for (std::size_t k = 0; k < stretches; ++k) {
    series.x.push_back((*left)[0] + (static_cast<double>(k) + 0.5) * width);
    series.y.push_back(highest[k]);
  }
  return series;
}

Series cloud_of(const std::vector<meshes::Point>& points) {
  Series series;
  series.style = Series::Style::points;
  for (const meshes::Point& x : points) {
    series.x.push_back(x[0]);
    series.y.push_back(x[1]);
  }
  return series;
}

}  // namespace

std::vector<Figure> body_figures(const meshes::Mesh& mesh, std::span<const meshes::Snapshot* const> times,
                                 const FigureHeading& heading) {
  if (mesh.dim != 2 || times.empty()) return {};
  const meshes::Snapshot& last = *times.back();
  if (last.node_displacement.empty() || last.points.position.empty()) return {};
  Figure figure = figure_frame(heading, {"x", "m"}, {"elevation", "m"});
  const double width = cell_size(mesh);
  constexpr int grey = 6;
  figure.series.push_back(cloud_of(last.points.position));
  figure.series.back().label = fmt::format("points, {:.6g} s", last.time);
  figure.series.back().colour = grey;
  int colour = 0;
  for (const meshes::Snapshot* snapshot : times) {
    figure.series.push_back(outline_of(snapshot->points.position, width));
    figure.series.back().label = fmt::format("{:.6g} s", snapshot->time);
    figure.series.back().colour = colour++;
  }
  return {figure};
}

std::vector<Figure> body_figures(const meshes::FieldHistory& history) {
  std::vector<const meshes::Snapshot*> times;
  for (const meshes::Snapshot& snapshot : history.snapshots) times.push_back(&snapshot);
  return body_figures(history.mesh, times,
                      {"body", "The body: its upper outline in time, its points at the end", "Profiles"});
}

}  // namespace wetfront::verification
