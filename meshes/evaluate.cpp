#include "meshes/evaluate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace wetfront::meshes {
namespace {

constexpr int search_axis = 0;

std::array<double, 2> extent_of_cell(const Mesh& mesh, int cell) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int node : mesh.cell(cell)) {
    low = std::min(low, mesh.nodes[node][search_axis]);
    high = std::max(high, mesh.nodes[node][search_axis]);
  }
  return {low, high};
}

/// Bilinear weights of the unit square at (r, s), counter-clockwise.
std::array<double, 4> bilinear(double r, double s) {
  return {(1 - r) * (1 - s), r * (1 - s), r * s, (1 - r) * s};
}

/// Inverts the bilinear map of a quadrilateral by Newton's method; returns local coordinates.
std::array<double, 2> local_coordinates(const Mesh& mesh, std::span<const int> cell, const Point& point) {
  double r = 0.5, s = 0.5;
  for (int iteration = 0; iteration < 30; ++iteration) {
    double residual[2] = {-point[0], -point[1]}, dr[2] = {}, ds[2] = {};
    const auto weight = bilinear(r, s);
    const double slope_r[4] = {-(1 - s), 1 - s, s, -s}, slope_s[4] = {-(1 - r), -r, r, 1 - r};
    for (int i = 0; i < 4; ++i)
      for (int axis = 0; axis < 2; ++axis) {
        const double x = mesh.nodes[cell[i]][axis];
        residual[axis] += weight[i] * x;
        dr[axis] += slope_r[i] * x;
        ds[axis] += slope_s[i] * x;
      }
    const double determinant = dr[0] * ds[1] - dr[1] * ds[0];
    const double step_r = (residual[0] * ds[1] - residual[1] * ds[0]) / determinant;
    const double step_s = (dr[0] * residual[1] - dr[1] * residual[0]) / determinant;
    r -= step_r;
    s -= step_s;
    if (std::abs(step_r) + std::abs(step_s) < 1e-14) break;
  }
  return {r, s};
}

/// Trilinear weights of the unit cube at (r, s, t), in gmsh's order, and their slopes along the three axes.
struct Trilinear {
  std::array<double, 8> weight;
  std::array<std::array<double, 8>, 3> slope;
};
Trilinear trilinear(const std::array<double, 3>& at) {
  static constexpr int corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                       {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  Trilinear out{};
  for (int c = 0; c < 8; ++c) {
    std::array<double, 3> along, change;
    for (int axis = 0; axis < 3; ++axis) {
      along[axis] = corner[c][axis] ? at[axis] : 1 - at[axis];
      change[axis] = corner[c][axis] ? 1 : -1;
    }
    out.weight[c] = along[0] * along[1] * along[2];
    for (int axis = 0; axis < 3; ++axis)
      out.slope[axis][c] = change[axis] * along[(axis + 1) % 3] * along[(axis + 2) % 3];
  }
  return out;
}

double determinant(const std::array<std::array<double, 3>, 3>& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// Inverts the trilinear map of a hexahedron by Newton's method; returns local coordinates.
std::array<double, 3> local_coordinates_in_space(const Mesh& mesh, std::span<const int> cell, const Point& point) {
  std::array<double, 3> at{0.5, 0.5, 0.5};
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Trilinear shape = trilinear(at);
    std::array<std::array<double, 3>, 3> jacobian{};  // jacobian[k]: change of the point along local axis k
    std::array<double, 3> residual{-point[0], -point[1], -point[2]};
    for (int c = 0; c < 8; ++c)
      for (int axis = 0; axis < 3; ++axis) {
        const double x = mesh.nodes[cell[c]][axis];
        residual[axis] += shape.weight[c] * x;
        for (int k = 0; k < 3; ++k) jacobian[k][axis] += shape.slope[k][c] * x;
      }
    const double whole = determinant(jacobian);
    double moved = 0;
    for (int k = 0; k < 3; ++k) {  // Cramer's rule
      auto replaced = jacobian;
      replaced[k] = residual;
      const double step = determinant(replaced) / whole;
      at[k] -= step;
      moved += std::abs(step);
    }
    if (!(moved > 1e-14)) break;
  }
  return at;
}

/// Whether a cell's bounding box holds the point: spares the inverse map of the cells beside and above.
bool may_hold(const Mesh& mesh, std::span<const int> cell, const Point& point, double slack) {
  for (int axis = 0; axis < mesh.dim; ++axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const int node : cell) {
      low = std::min(low, mesh.nodes[node][axis]);
      high = std::max(high, mesh.nodes[node][axis]);
    }
    const double margin = slack + 1e-7 * (high - low);
    if (point[axis] < low - margin || point[axis] > high + margin) return false;
  }
  return true;
}

}  // namespace

Evaluator::Evaluator(const Mesh& mesh) : mesh_(&mesh), order_(mesh.cell_count()), lower_(mesh.cell_count()) {
  std::iota(order_.begin(), order_.end(), 0);
  std::sort(order_.begin(), order_.end(),
            [&](int a, int b) { return extent_of_cell(mesh, a)[0] < extent_of_cell(mesh, b)[0]; });
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const auto [from, to] = extent_of_cell(mesh, order_[i]);
    lower_[i] = from;
    largest_extent_ = std::max(largest_extent_, to - from);
    low = std::min(low, from);
    high = std::max(high, to);
  }
  tolerance_ = 1e-9 * (high - low);
}

std::optional<Evaluator::Weights> Evaluator::weights_if_inside(const Point& point) const {
  const double x = point[search_axis];
  auto candidate = std::upper_bound(lower_.begin(), lower_.end(), x + tolerance_);
  while (candidate != lower_.begin()) {
    --candidate;
    if (*candidate < x - largest_extent_ - tolerance_) break;
    const auto cell = mesh_->cell(order_[candidate - lower_.begin()]);
    if (mesh_->dim == 1) {
      const double from = mesh_->nodes[cell[0]][0], to = mesh_->nodes[cell[1]][0], r = (x - from) / (to - from);
      if (x >= from - tolerance_ && x <= to + tolerance_) return Weights{{cell[0], cell[1]}, {1 - r, r}};
      continue;
    }
    if (!may_hold(*mesh_, cell, point, tolerance_)) continue;
    constexpr double slack = 1e-7;
    if (mesh_->dim == 3) {
      const auto at = local_coordinates_in_space(*mesh_, cell, point);
      if (!std::ranges::all_of(at, [](double local) { return local > -slack && local < 1 + slack; })) continue;
      const auto weight = trilinear(at).weight;
      return Weights{{cell.begin(), cell.end()}, {weight.begin(), weight.end()}};
    }
    const auto [r, s] = local_coordinates(*mesh_, cell, point);
    if (r > -slack && r < 1 + slack && s > -slack && s < 1 + slack) {
      const auto weight = bilinear(r, s);
      return Weights{{cell.begin(), cell.end()}, {weight.begin(), weight.end()}};
    }
  }
  return std::nullopt;
}

Evaluator::Weights Evaluator::weights(const Point& point) const {
  if (auto found = weights_if_inside(point)) return std::move(*found);
  throw std::out_of_range("the point (" + std::to_string(point[0]) + ", " + std::to_string(point[1]) + ", " +
                          std::to_string(point[2]) + ") m lies outside the mesh");
}

double Evaluator::operator()(const std::vector<double>& nodal, const Point& point) const {
  const Weights at = weights(point);
  double value = 0;
  for (std::size_t i = 0; i < at.node.size(); ++i) value += at.weight[i] * nodal[at.node[i]];
  return value;
}

}  // namespace wetfront::meshes
