#include "verification/present/surface_rain.h"

#include "verification/present/figure_frame.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace wetfront::verification {
namespace {

constexpr double mm = 1e-3;

double width_of_cell(const meshes::Mesh& mesh) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const int node : mesh.cell(0)) {
    low = std::min(low, mesh.nodes[static_cast<std::size_t>(node)][0]);
    high = std::max(high, mesh.nodes[static_cast<std::size_t>(node)][0]);
  }
  return high - low;
}

void add_series(reports::Figure& figure, const SurfaceRain& rain, const std::string& who,
                reports::Series::Style style) {
  int colour = 0;
  for (const auto& [what, values] :
       {std::pair{"fallen", &rain.fallen}, {"taken", &rain.taken}, {"run off", &rain.run_off}})
    figure.series.push_back({who + ", " + what, style, rain.x, *values, colour++});
}

}  // namespace

SurfaceRain rain_over_surface(const std::vector<meshes::NodeRain>& nodes, const meshes::Mesh& mesh) {
  SurfaceRain rain;
  if (mesh.cell_count() == 0) return rain;
  const double near = width_of_cell(mesh) / 3;
  auto sorted = nodes;
  std::ranges::sort(sorted, {}, [](const meshes::NodeRain& node) { return node.position[0]; });
  for (const meshes::NodeRain& node : sorted) {
    if (rain.x.empty() || node.position[0] - rain.x.back() > near) {
      rain.x.push_back(node.position[0]);
      for (auto* column : {&rain.fallen, &rain.taken, &rain.run_off}) column->push_back(0);
    }
    rain.fallen.back() += node.asked;
    rain.taken.back() += node.imposed;
    rain.run_off.back() += node.run_off;
  }
  const std::size_t places = rain.x.size();
  if (places < 2) return {};
  for (std::size_t i = 0; i < places; ++i) {
    const double width = (rain.x[std::min(i + 1, places - 1)] - rain.x[i == 0 ? 0 : i - 1]) / 2;
    for (auto* column : {&rain.fallen, &rain.taken, &rain.run_off}) (*column)[i] /= width * mm;
  }
  return rain;
}

std::optional<reports::Figure> surface_rain_figure(const meshes::FieldHistory& candidate, double failure,
                                                   const meshes::FieldHistory* reference) {
  if (candidate.mesh.dim != 2) return {};
  const SurfaceRain here = rain_over_surface(candidate.rain_by_node, candidate.mesh);
  if (here.x.size() < 3) return {};  // a column is a strip of one cell
  const std::string when = std::isfinite(failure) ? ", slide and all" : "";
  reports::Figure figure =
      figure_frame({"surface_rain", "Rain over the surface until the end of the run" + when, "Flux audit"}, {"x", "m"},
                   {"water per horizontal area", "mm"});
  add_series(figure, here, "MPM", reports::Series::Style::line);
  const auto between = [](const meshes::NodeRain& node) { return node.node < 0; };
  if (reference != nullptr && reference->mesh.dim == 2 && !std::isfinite(failure) &&
      std::ranges::none_of(reference->rain_by_node, between))
    add_series(figure, rain_over_surface(reference->rain_by_node, reference->mesh), "reference",
               reports::Series::Style::dashed);
  return figure;
}

}  // namespace wetfront::verification
