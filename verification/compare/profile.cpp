#include "verification/compare/profile.h"

#include "meshes/evaluate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

/// Reads nodal fields of one mesh at places given in the dimension of another.
class Sampler {
 public:
  Sampler(const meshes::Mesh& mesh, const std::vector<meshes::Point>& places, int dim) {
    const meshes::Evaluator evaluate(mesh);
    for (const meshes::Point& place : places)
      at_.push_back(evaluate.weights(mesh.dim == 1 ? meshes::Point{place[meshes::up_axis(dim)]} : place));
  }

  std::vector<double> operator()(const std::vector<double>& nodal) const {
    std::vector<double> values;
    for (const auto& weights : at_) {
      double value = 0;
      for (std::size_t i = 0; i < weights.node.size(); ++i) value += weights.weight[i] * nodal[weights.node[i]];
      values.push_back(value);
    }
    return values;
  }

 private:
  std::vector<meshes::Evaluator::Weights> at_;
};

}  // namespace

std::vector<Profile> cell_profiles(const meshes::FieldHistory& candidate) {
  std::vector<Profile> profiles;
  for (const meshes::Snapshot& snapshot : candidate.snapshots)
    profiles.push_back({snapshot.time, snapshot.cell_pressure, snapshot.cell_saturation});
  return profiles;
}

std::vector<Profile> profiles_at_cells(const meshes::FieldHistory& history, const meshes::Mesh& cells_of) {
  std::vector<meshes::Point> centres;
  for (std::size_t c = 0; c < cells_of.cell_count(); ++c) centres.push_back(cells_of.cell_centre(c));
  const Sampler sample(history.mesh, centres, cells_of.dim);
  std::vector<Profile> profiles;
  for (const meshes::Snapshot& snapshot : history.snapshots)
    profiles.push_back({snapshot.time, sample(snapshot.node_pressure), sample(snapshot.node_saturation)});
  return profiles;
}

std::vector<std::vector<double>> pressure_at_nodes(const meshes::FieldHistory& history, const meshes::Mesh& nodes_of) {
  const Sampler sample(history.mesh, nodes_of.nodes, nodes_of.dim);
  std::vector<std::vector<double>> pressures;
  for (const meshes::Snapshot& snapshot : history.snapshots) pressures.push_back(sample(snapshot.node_pressure));
  return pressures;
}

std::vector<double> cell_measures(const meshes::Mesh& mesh) {
  std::vector<double> measures;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) measures.push_back(mesh.cell_measure(c));
  return measures;
}

double relative_l2(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& weight) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    difference += weight[i] * (a[i] - b[i]) * (a[i] - b[i]);
    size += weight[i] * b[i] * b[i];
  }
  return std::sqrt(difference / size);
}

double root_mean_square(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& weight) {
  double squares = 0, total = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    squares += weight[i] * (a[i] - b[i]) * (a[i] - b[i]);
    total += weight[i];
  }
  return std::sqrt(squares / total);
}

double relative_linf(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
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
