#include "verification/present/contours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace wetfront::verification {
namespace {

using Edge = std::pair<int, int>;  ///< node indices, the lower first

Edge edge(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

/// Joins pieces that share an end to lines, NaN between them. `Key` tells ends, `place` puts them on the plane.
template <class Key, class Place>
reports::Series joined(const std::vector<std::pair<Key, Key>>& pieces, Place place) {
  std::multimap<Key, std::size_t> at;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    at.emplace(pieces[i].first, i);
    at.emplace(pieces[i].second, i);
  }
  std::vector<bool> used(pieces.size(), false);
  reports::Series series;
  const auto add = [&](const Key& key) {
    const meshes::Point point = place(key);
    series.x.push_back(point[0]);
    series.y.push_back(point[1]);
  };
  const auto walk = [&](std::size_t first, Key from) {
    if (!series.x.empty()) {
      series.x.push_back(std::numeric_limits<double>::quiet_NaN());
      series.y.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    add(from);
    for (std::size_t piece = first; piece < pieces.size();) {
      used[piece] = true;
      from = pieces[piece].first == from ? pieces[piece].second : pieces[piece].first;
      add(from);
      piece = pieces.size();
      for (auto [next, end] = at.equal_range(from); next != end; ++next)
        if (!used[next->second]) piece = next->second;
    }
  };
  for (std::size_t i = 0; i < pieces.size(); ++i)  // open lines from their ends first, then closed ones
    for (const Key& end : {pieces[i].first, pieces[i].second})
      if (!used[i] && at.count(end) == 1) walk(i, end);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (!used[i]) walk(i, pieces[i].first);
  return series;
}

/// Edges of the mesh with the regions on their two sides, -1 outside.
std::map<Edge, std::array<int, 2>> edges_of(const meshes::Mesh& mesh) {
  std::map<Edge, std::array<int, 2>> edges;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const auto cell = mesh.cell(c);
    for (int i = 0; i < 4; ++i) {
      const auto [found, fresh] = edges.emplace(edge(cell[i], cell[(i + 1) % 4]), std::array{mesh.region[c], -1});
      if (!fresh) found->second[1] = mesh.region[c];
    }
  }
  return edges;
}

template <class Wanted>
reports::Series edge_series(const meshes::Mesh& mesh, Wanted wanted) {
  std::vector<Edge> pieces;
  for (const auto& [nodes, regions] : edges_of(mesh))
    if (wanted(regions)) pieces.push_back(nodes);
  return joined(pieces, [&](int node) { return mesh.nodes[node]; });
}

}  // namespace

reports::Series contour(const meshes::Mesh& mesh, const std::vector<double>& nodal, double value) {
  std::vector<std::pair<Edge, Edge>> pieces;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const auto cell = mesh.cell(c);
    std::vector<int> crossed;  // edges, counter-clockwise from a crossing upwards where the cell is a saddle
    double mean = 0;
    for (int i = 0; i < 4; ++i) {
      mean += nodal[cell[i]] / 4;
      if ((nodal[cell[i]] >= value) != (nodal[cell[(i + 1) % 4]] >= value)) crossed.push_back(i);
    }
    const auto of = [&](int i) { return edge(cell[i], cell[(i + 1) % 4]); };
    if (crossed.size() == 2) pieces.emplace_back(of(crossed[0]), of(crossed[1]));
    if (crossed.size() == 4) {
      const bool joins = (nodal[cell[0]] >= value) == (mean >= value);  // corners 0 and 2 hang together
      pieces.emplace_back(of(0), of(joins ? 1 : 3));
      pieces.emplace_back(of(2), of(joins ? 3 : 1));
    }
  }
  return joined(pieces, [&](const Edge& nodes) {
    const double a = nodal[nodes.first], b = nodal[nodes.second], share = (value - a) / (b - a);
    meshes::Point point{};
    for (int axis = 0; axis < 2; ++axis)
      point[axis] = mesh.nodes[nodes.first][axis] * (1 - share) + mesh.nodes[nodes.second][axis] * share;
    return point;
  });
}

reports::Series outline(const meshes::Mesh& mesh) {
  return edge_series(mesh, [](const std::array<int, 2>& regions) { return regions[1] < 0; });
}

reports::Series region_boundaries(const meshes::Mesh& mesh) {
  return edge_series(mesh,
                     [](const std::array<int, 2>& regions) { return regions[1] >= 0 && regions[0] != regions[1]; });
}

std::vector<double> round_levels(double low, double high, int count) {
  std::vector<double> levels;
  const double raw = (high - low) / count;
  if (!(raw > 0) || !std::isfinite(raw)) return levels;
  const double power = std::pow(10, std::floor(std::log10(raw))), mantissa = raw / power;
  const double step = power * (mantissa <= 1 ? 1 : mantissa <= 2 ? 2 : mantissa <= 5 ? 5 : 10);
  for (double level = std::ceil(low / step) * step; level < high; level += step)
    if (level > low) levels.push_back(std::abs(level) < 1e-9 * step ? 0 : level);
  return levels;
}

}  // namespace wetfront::verification
