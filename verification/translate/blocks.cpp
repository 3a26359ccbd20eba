#include "verification/translate/blocks.h"

#include "meshes/block_script.h"
#include "meshes/gmsh.h"

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

using Line = std::vector<double>;  ///< elevations, one per station

constexpr double close = 1e-6;  ///< m: boundaries nearer than this to another are not worth a row of cells

/// Cells above the surface, as high as those below in the mean.
void add_room(meshes::PlaneBlocks& blocks, double room) {
  Line line = blocks.line.back();
  double thickness = 0;
  int rows = 0;
  for (std::size_t i = 0; i < line.size(); ++i) thickness += (line[i] - blocks.line.front()[i]) / line.size();
  for (const int count : blocks.cells_over) rows += count;
  for (double& elevation : line) elevation += room;
  blocks.line.push_back(line);
  blocks.cells_over.push_back(std::max(1, static_cast<int>(std::lround(rows * room / thickness))));
}

/// `total` cells shared out among stretches of these lengths, at least one each and mostly even numbers, so that the
/// mesh is twice as fine as another.
std::vector<int> shared_out(const std::vector<double>& ends, int total) {
  if (ends.size() == 2) return {total};
  std::vector<int> cells;
  const double length = ends.back() - ends.front();
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double share = total * (ends[i] - ends[i - 1]) / length;
    cells.push_back(share < 1.5 ? 1 : 2 * static_cast<int>(std::lround(share / 2)));
  }
  return cells;
}

void halve(std::vector<int>& cells, int halvings) {
  for (int& count : cells) count = halvings < 0 ? count >> -halvings : count << halvings;
}

bool all_even(const std::vector<int>& cells) {
  return std::all_of(cells.begin(), cells.end(), [](int count) { return count % 2 == 0; });
}

/// Edges of zones and parts along one axis that lie inside (low, high), added to `places`.
void add_edges(const Geometry& geometry, int axis, std::vector<double>& places) {
  const double low = places.front(), high = places.back();
  const auto add = [&](const Extent& extent) {
    for (const double edge : {extent.from[axis] + Extent::slack, extent.to[axis] - Extent::slack}) {
      const bool apart =
          std::all_of(places.begin(), places.end(), [&](double place) { return std::abs(place - edge) > close; });
      if (edge > low && edge < high && apart) places.push_back(edge);
    }
  };
  for (const Zone& zone : geometry.zones) add(zone.extent);
  for (const SidePart& part : geometry.parts) add(part.extent);
  std::sort(places.begin(), places.end());
}

/// Inserts a line between those it lies between all along; one that touches or crosses another is left out.
void insert(std::vector<Line>& lines, const Line& line) {
  const auto below = [](const Line& a, const Line& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (!(b[i] - a[i] > close)) return false;
    return true;
  };
  for (std::size_t j = 1; j < lines.size(); ++j)
    if (below(lines[j - 1], line) && below(line, lines[j])) {
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(j), line);
      return;
    }
}

/// Lines of blocks over the stations `x`, from the base up.
std::vector<Line> lines_over(const Geometry& geometry, const std::vector<double>& x) {
  Line base, surface;
  for (const double place : x) {
    base.push_back(base_at(geometry, place));
    surface.push_back(surface_at(geometry, place));
  }
  std::vector<Line> lines = {base, surface};
  for (std::size_t i = 0; i < geometry.layers.size(); ++i) {
    Line line;
    for (const double place : x) line.push_back(layer_bottoms(geometry, place)[i]);
    insert(lines, line);
  }
  std::vector<double> edges = {*std::min_element(base.begin(), base.end()),
                               *std::max_element(surface.begin(), surface.end())};
  add_edges(geometry, 1, edges);
  for (std::size_t e = 1; e + 1 < edges.size(); ++e) insert(lines, Line(x.size(), edges[e]));
  return lines;
}

meshes::PlaneBlocks plane_blocks(const Geometry& geometry, int cells, int along) {
  meshes::PlaneBlocks blocks;
  blocks.x = stations(geometry);
  add_edges(geometry, 0, blocks.x);
  blocks.line = lines_over(geometry, blocks.x);
  blocks.cells_along = shared_out(blocks.x, along);
  std::vector<double> heights;  // mean elevations: they say how thick a row of blocks is
  for (const Line& line : blocks.line) {
    double sum = 0;
    for (const double elevation : line) sum += elevation;
    heights.push_back(sum / static_cast<double>(line.size()));
  }
  blocks.cells_over = shared_out(heights, cells);
  return blocks;
}

meshes::SpaceBlocks space_blocks(const Geometry& geometry, const Box& box, int cells, int along_factor) {
  meshes::SpaceBlocks blocks;
  for (int axis = 0; axis < 3; ++axis) {
    blocks.plane[axis] = {0, box.size[axis]};
    add_edges(geometry, axis, blocks.plane[axis]);
  }
  std::vector<Line> lines;
  for (const double z : blocks.plane[2]) lines.push_back({z});
  for (const double bottom : layer_bottoms(geometry, 0)) insert(lines, {bottom});
  blocks.plane[2].clear();
  for (const Line& line : lines) blocks.plane[2].push_back(line[0]);
  for (int axis = 0; axis < 3; ++axis)
    blocks.cells[axis] = shared_out(blocks.plane[axis], axis == 2 ? cells : box.cells[axis] * along_factor);
  return blocks;
}

int own_along(const Geometry& geometry) {
  if (const auto* box = std::get_if<Box>(&geometry.shape)) return box->cells[0];
  if (const auto* slope = std::get_if<Slope>(&geometry.shape)) return slope->cells_along;
  if (const auto* profile = std::get_if<GroundProfile>(&geometry.shape)) return profile->cells_along;
  return 1;
}

std::vector<double> elevations_of(const Geometry& geometry) {
  std::vector<double> elevations;
  for (const Line& line : lines_over(geometry, {0})) elevations.push_back(line[0]);
  return elevations;
}

}  // namespace

meshes::Mesh block_mesh(const Geometry& geometry, const BlockCells& wanted) {
  if (geometry.dim() == 3) {
    auto blocks = space_blocks(geometry, std::get<Box>(geometry.shape), wanted.over, wanted.along_factor);
    for (auto& cells : blocks.cells) halve(cells, wanted.halvings);
    return meshes::generate(meshes::blocks_in_space(blocks), 3);
  }
  auto blocks = plane_blocks(geometry, wanted.over, own_along(geometry) * wanted.along_factor);
  if (wanted.room > 0) add_room(blocks, wanted.room);
  for (auto* cells : {&blocks.cells_along, &blocks.cells_over}) halve(*cells, wanted.halvings);
  return meshes::generate(meshes::blocks_in_plane(blocks), 2);
}

meshes::Mesh line_mesh(const Geometry& geometry, int cells, int halvings) {
  const std::vector<double> elevations = elevations_of(geometry);
  std::vector<int> between = shared_out(elevations, cells);
  halve(between, halvings);
  return meshes::generate(meshes::blocks_of_line(elevations, between), 1);
}

bool can_coarsen(const Geometry& geometry, int over, int along_factor) {
  if (std::holds_alternative<Column>(geometry.shape)) return all_even(shared_out(elevations_of(geometry), over));
  if (geometry.dim() == 3) {
    const auto blocks = space_blocks(geometry, std::get<Box>(geometry.shape), over, along_factor);
    return all_even(blocks.cells[0]) && all_even(blocks.cells[1]) && all_even(blocks.cells[2]);
  }
  const auto blocks = plane_blocks(geometry, over, own_along(geometry) * along_factor);
  return all_even(blocks.cells_along) && all_even(blocks.cells_over);
}

}  // namespace wetfront::verification
