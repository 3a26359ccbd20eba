#include "verification/present/body_figures.h"

#include "verification/present/figure_frame.h"

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

std::vector<Figure> body_figures(const meshes::FieldHistory& history) {
  if (history.mesh.dim != 2 || history.snapshots.empty()) return {};
  const meshes::Snapshot& last = history.snapshots.back();
  if (last.node_displacement.empty() || last.points.position.empty()) return {};
  Figure figure = figure_frame({"body", "The body: its upper outline in time, its points at the end", "Profiles"},
                               {"x", "m"}, {"elevation", "m"});
  const double width = cell_size(history.mesh);
  constexpr int grey = 6;
  figure.series.push_back(cloud_of(last.points.position));
  figure.series.back().label = fmt::format("points, {:.6g} s", last.time);
  figure.series.back().colour = grey;
  int colour = 0;
  for (const meshes::Snapshot& snapshot : history.snapshots) {
    figure.series.push_back(outline_of(snapshot.points.position, width));
    figure.series.back().label = fmt::format("{:.6g} s", snapshot.time);
    figure.series.back().colour = colour++;
  }
  return {figure};
}

}  // namespace wetfront::verification
