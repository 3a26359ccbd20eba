#include "verification/compare/profile.h"

#include "meshes/evaluate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace wetfront::verification {
namespace {

/// Reads nodal fields of one mesh at places given in the dimension of another; 0 at places outside.
class Sampler {
 public:
  Sampler(const meshes::Evaluator& evaluate, const std::vector<meshes::Point>& places, int dim) {
    for (const meshes::Point& place : places)
      at_.push_back(
          evaluate.weights_if_inside(evaluate.dim() == 1 ? meshes::Point{place[meshes::up_axis(dim)]} : place));
  }

  std::vector<double> operator()(const std::vector<double>& nodal) const {
    std::vector<double> values;
    for (const auto& weights : at_) {
      double value = 0;
      for (std::size_t i = 0; weights && i < weights->node.size(); ++i)
        value += weights->weight[i] * nodal[weights->node[i]];
      values.push_back(value);
    }
    return values;
  }

  /// 1 per place inside, 0 per place outside.
  std::vector<double> inside() const {
    std::vector<double> marks;
    for (const auto& weights : at_) marks.push_back(weights ? 1 : 0);
    return marks;
  }

 private:
  std::vector<std::optional<meshes::Evaluator::Weights>> at_;
};

/// Midpoints per direction for the average over a cell: 8 leave 1/64 of what a single one misses of a curved profile.
constexpr int parts_of_average = 8;

/// Midpoints of parts x parts equal pieces of a quadrilateral (of parts pieces of a line).
std::vector<meshes::Point> places_in_cell(const meshes::Mesh& mesh, std::size_t cell, int parts) {
  if (parts == 1) return {mesh.cell_centre(cell)};
  const auto corner = mesh.cell(cell);
  std::vector<meshes::Point> places;
  for (int i = 0; i < parts; ++i)
    for (int j = 0; j < (mesh.dim == 1 ? 1 : parts); ++j) {
      const double r = (i + 0.5) / parts, s = (j + 0.5) / parts;
      const std::array<double, 4> weight =
          mesh.dim == 1 ? std::array<double, 4>{1 - r, r, 0, 0}
                        : std::array<double, 4>{(1 - r) * (1 - s), r * (1 - s), r * s, (1 - r) * s};
      meshes::Point place{};
      for (std::size_t c = 0; c < corner.size(); ++c)
        for (int axis = 0; axis < 3; ++axis) place[axis] += weight[c] * mesh.nodes[corner[c]][axis];
      places.push_back(place);
    }
  return places;
}

/// Reads nodal fields of one mesh in the cells of another: the mean over `parts` places per direction.
class CellReader {
 public:
  CellReader(const meshes::Mesh& mesh, const meshes::Mesh& cells_of, int parts) {
    const meshes::Evaluator evaluate(mesh);
    for (std::size_t c = 0; c < cells_of.cell_count(); ++c)
      cells_.emplace_back(evaluate, places_in_cell(cells_of, c, parts), cells_of.dim);
  }

  std::vector<double> operator()(const std::vector<double>& nodal) const {
    std::vector<double> values;
    for (const Sampler& cell : cells_) {
      double sum = 0;
      const auto samples = cell(nodal);
      for (const double sample : samples) sum += sample;
      const auto inside = cell.inside();
      const double count = std::accumulate(inside.begin(), inside.end(), 0.0);
      values.push_back(count > 0 ? sum / count : 0);
    }
    return values;
  }

 private:
  std::vector<Sampler> cells_;
};

}  // namespace

std::vector<Profile> cell_profiles(const meshes::FieldHistory& candidate) {
  std::vector<Profile> profiles;
  for (const meshes::Snapshot& snapshot : candidate.snapshots)
    profiles.push_back({snapshot.time, snapshot.cell_pressure, snapshot.cell_saturation});
  return profiles;
}

std::vector<Profile> profiles_at_cells(const meshes::FieldHistory& history, const meshes::FieldHistory& candidate) {
  std::optional<CellReader> at_centres, averaged;
  std::vector<Profile> profiles;
  for (std::size_t t = 0; t < std::min(history.snapshots.size(), candidate.snapshots.size()); ++t) {
    const meshes::Snapshot& snapshot = history.snapshots[t];
    const bool average = candidate.snapshots[t].cells_hold_averages;
    auto& reader = average ? averaged : at_centres;
    if (!reader) reader.emplace(history.mesh, candidate.mesh, average ? parts_of_average : 1);
    profiles.push_back({snapshot.time, (*reader)(snapshot.node_pressure), (*reader)(snapshot.node_saturation)});
  }
  return profiles;
}

std::vector<std::vector<double>> values_at_nodes(const meshes::Mesh& mesh,
                                                 const std::vector<const std::vector<double>*>& nodal,
                                                 const meshes::Mesh& nodes_of) {
  const Sampler sample(meshes::Evaluator(mesh), nodes_of.nodes, nodes_of.dim);
  std::vector<std::vector<double>> values;
  for (const std::vector<double>* field : nodal) values.push_back(sample(*field));
  return values;
}

std::vector<std::vector<double>> pressure_at_nodes(const meshes::FieldHistory& history, const meshes::Mesh& nodes_of) {
  std::vector<const std::vector<double>*> pressures;
  for (const meshes::Snapshot& snapshot : history.snapshots) pressures.push_back(&snapshot.node_pressure);
  return values_at_nodes(history.mesh, pressures, nodes_of);
}

std::vector<double> cell_weights(const meshes::Mesh& mesh, const meshes::Mesh& reference) {
  std::vector<meshes::Point> centres;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) centres.push_back(mesh.cell_centre(c));
  std::vector<double> weights = Sampler(meshes::Evaluator(reference), centres, mesh.dim).inside();
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) weights[c] *= mesh.cell_measure(c);
  return weights;
}

std::vector<double> node_weights(const meshes::Mesh& mesh, const meshes::Mesh& reference) {
  return Sampler(meshes::Evaluator(reference), mesh.nodes, mesh.dim).inside();
}

double relative_l2(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& weight) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (weight[i] == 0) continue;
    difference += weight[i] * (a[i] - b[i]) * (a[i] - b[i]);
    size += weight[i] * b[i] * b[i];
  }
  return std::sqrt(difference / size);
}

double root_mean_square(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& weight) {
  double squares = 0, total = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (weight[i] == 0) continue;
    squares += weight[i] * (a[i] - b[i]) * (a[i] - b[i]);
    total += weight[i];
  }
  return std::sqrt(squares / total);
}

double relative_linf(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& weight) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    if (weight[i] == 0) continue;
    if (!std::isfinite(a[i])) return std::numeric_limits<double>::infinity();
    difference = std::max(difference, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(b[i]));
  }
  return difference / size;
}

double front_elevation(const std::vector<double>& saturation, const std::vector<double>& elevation) {
  const std::size_t top = saturation.size() - 1;
  const double driest = *std::min_element(saturation.begin(), saturation.end());
  if (!(saturation[top] > driest + 0.01)) return std::numeric_limits<double>::quiet_NaN();
  const double middle = 0.5 * (saturation[top] + driest);
  std::size_t below = top;
  while (saturation[below] > middle) --below;
  const double fraction = (middle - saturation[below]) / (saturation[below + 1] - saturation[below]);
  return elevation[below] + fraction * (elevation[below + 1] - elevation[below]);
}

}  // namespace wetfront::verification
