#include "mpm/boundary/surface.h"

#include "mpm/boundary/fitted_line.h"
#include "mpm/grid/soils_of_cells.h"

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {

namespace {

/// Corners around which less than this is filled lie at or beyond the surface; a straight one leaves at most about
/// half.
constexpr double corner_near_surface = 0.75;
/// A part of a face shorter than this is round-off.
constexpr double shortest_part = 1e-12;
/// Lines of neighbours that miss each other by less than this part of a face are one surface, by more a cliff.
constexpr double longest_gap = 0.25;

Polygon polygon_of(const Grid<2>& grid, std::size_t cell) {
  Polygon polygon;
  for (int i = 0; i < 4; ++i) polygon.add(grid.node(grid.cell_nodes_of(cell)[i]));
  return polygon;
}

}  // namespace

template <int dim>
Surface<dim>::Surface(const Grid<dim>& grid, const MaterialPoints<dim>& points, const meshes::Mesh& mesh)
    : grid_(grid),
      points_(points),
      faces_(grid, mesh),
      cell_volume_(grid.cell_count(), 0.0),
      node_volume_(grid.node_count(), 0.0),
      volume_(grid.cell_count(), -1.0),
      fill_(grid.cell_count(), 0.0),
      node_fill_(grid.node_count(), 0.0),
      centroid_(grid.cell_count()),
      line_of_(grid.cell_count(), -1) {
  const double gauss = 1 / std::sqrt(3.0);
  Stencil<dim> s;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell)
    for (int k = 0; k < cell_nodes<dim>; ++k) {
      Vector<dim> xi{};
      for (int a = 0; a < dim; ++a) xi[a] = gauss * node_sign(k, a);
      const double volume = grid.stencil(cell, xi, s);
      cell_volume_[cell] += volume;
      for (int i = 0; i < cell_nodes<dim>; ++i)
        node_volume_[static_cast<std::size_t>(grid.cell_nodes_of(cell)[i])] += volume * s.value[i];
    }
}

template <int dim>
bool Surface<dim>::measure_cells() {
  const Column& volume = *points_.columns.find("volume");
  seen_.assign(grid_.cell_count(), 0);
  bool changed = false;
  each_cell(points_, [&](std::span<const Block* const> blocks) {
    const std::size_t cell = blocks.front()->cell;
    double sum = 0;
    Vector<dim> moment{};
    for (const Block* block : blocks)
      for (std::size_t p = block->first; p < block->first + block->count; ++p) {
        const Vector<dim> x = points_.position(p);
        sum += volume[0][p];
        for (int a = 0; a < dim; ++a) moment[a] += volume[0][p] * x[a];
      }
    for (double& component : moment) component /= sum;
    changed = changed || sum != volume_[cell] || moment != centroid_[cell];
    volume_[cell] = sum;
    centroid_[cell] = moment;
    fill_[cell] = sum / cell_volume_[cell];
    seen_[cell] = 1;
  });
  for (std::size_t cell = 0; cell < seen_.size(); ++cell) {
    if (seen_[cell] != 0 || volume_[cell] == 0) continue;
    volume_[cell] = fill_[cell] = 0;
    changed = true;
  }
  return changed;
}

template <int dim>
void Surface<dim>::fill_nodes() {
  const Column& volume = *points_.columns.find("volume");
  std::ranges::fill(node_fill_, 0.0);
  Stencil<dim> s;
  for (const Block& block : points_.blocks())
    for (std::size_t p = block.first; p < block.first + block.count; ++p) {
      reference_stencil<dim>(grid_.local(block.cell, points_.position(p)), s);
      for (int i = 0; i < cell_nodes<dim>; ++i)
        node_fill_[static_cast<std::size_t>(block.nodes[i])] += volume[0][p] * s.value[i];
    }
  for (std::size_t i = 0; i < node_fill_.size(); ++i) node_fill_[i] /= node_volume_[i];
}

template <int dim>
bool Surface<dim>::near_surface(std::size_t cell) const {
  for (int i = 0; i < cell_nodes<dim>; ++i) {
    const int node = grid_.cell_nodes_of(cell)[i];
    const double enough = faces_.border_node(node) ? 1 - full_within : corner_near_surface;
    if (node_fill_[static_cast<std::size_t>(node)] < enough) return true;
  }
  for (int face = 0; face < cell_faces<dim>; ++face) {
    const int other = faces_.neighbour(cell, face);
    if (other >= 0 && !points_.occupied(static_cast<std::size_t>(other))) return true;
  }
  return false;
}

/// Out of the soil: against the gradient of the nodal fill at the centre of the cell.
template <int dim>
Vector<2> Surface<dim>::gradient_direction(std::size_t cell) const {
  Stencil<dim> s;
  grid_.stencil(cell, {}, s);
  Vector<2> out{};
  for (int i = 0; i < cell_nodes<dim>; ++i)
    for (int a = 0; a < 2; ++a)
      out[a] -= s.gradient[i][a] * node_fill_[static_cast<std::size_t>(grid_.cell_nodes_of(cell)[i])];
  double size = length<2>(out);
  // Points all around alike (a heap of one cell): from the centroid of the points to the middle, or upwards.
  if (!(size * grid_.smallest_altitude(cell) > 1e-6)) {
    const Vector<dim> middle = grid_.place(cell, {});
    for (int a = 0; a < 2; ++a) out[a] = middle[a] - centroid_[cell][a];
    size = length<2>(out);
    if (!(size > 1e-6 * grid_.smallest_altitude(cell))) return {0, 1};
  }
  return {out[0] / size, out[1] / size};
}

template <int dim>
void Surface<dim>::place_line(std::size_t cell) {
  if constexpr (dim == 2) {
    const Polygon polygon = polygon_of(grid_, cell);
    const double area = fill_[cell] * measure(polygon).area;
    Line line{cell, fitted_line(polygon, area, centroid_[cell], gradient_direction(cell)), {-1, -1}, {}};
    for (int face = 0; face < 4; ++face) {
      const double from = line.soil.beyond(polygon[face]), until = line.soil.beyond(polygon[(face + 1) % 4]);
      if ((from <= 0) == (until <= 0)) continue;
      const std::size_t end = from <= 0 ? 0 : 1;
      line.face[end] = face;
      line.at[end] = from / (from - until);
    }
    if (line.face[0] < 0 || line.face[1] < 0) return;  // fill below round-off
    line_of_[cell] = static_cast<int>(lines_.size());
    lines_.push_back(line);
  }
}

/// Two lines that end on one face from its two sides, with the soil on the same part of it, end in one point.
template <int dim>
void Surface<dim>::join_lines() {
  for (Line& line : lines_)
    for (std::size_t end = 0; end < 2; ++end) {
      const int other = faces_.neighbour(line.cell, line.face[end]);
      if (other < 0 || line_of_[static_cast<std::size_t>(other)] < 0 || static_cast<std::size_t>(other) < line.cell)
        continue;
      Line& next = lines_[static_cast<std::size_t>(line_of_[static_cast<std::size_t>(other)])];
      const std::size_t its = 1 - end;  // across the face its soil ends where ours begins along the line
      if (faces_.neighbour(next.cell, next.face[its]) != static_cast<int>(line.cell)) continue;
      const double middle = 0.5 * (line.at[end] + 1 - next.at[its]);
      line.at[end] = middle;
      next.at[its] = 1 - middle;
    }
}

/// The part of a face that the soil of a cell touches.
template <int dim>
typename Surface<dim>::Interval Surface<dim>::covered(std::size_t cell, int face) const {
  if (!points_.occupied(cell)) return {};
  if (line_of_[cell] < 0) return {0, 1};
  const Line& line = lines_[static_cast<std::size_t>(line_of_[cell])];
  if (line.face[0] == face) return {0, line.at[0]};
  if (line.face[1] == face) return {line.at[1], 1};
  const int node = grid_.cell_nodes_of(cell)[face];
  Vector<2> x{};
  std::copy_n(grid_.node(node).begin(), 2, x.begin());
  return line.soil.beyond(x) <= 0 ? Interval{0, 1} : Interval{};
}

/// On a face of a cell, without area yet.
template <int dim>
SurfacePiece<dim> Surface<dim>::piece_on(std::size_t cell, int face) const {
  SurfacePiece<dim> piece;
  piece.cell = cell;
  piece.fill = fill_[cell];
  piece.face = face;
  piece.border = faces_.neighbour(cell, face) < 0;
  piece.side = faces_.side(cell, face);
  return piece;
}

template <int dim>
void Surface<dim>::add_part(std::size_t cell, int face, Interval part) {
  if (part.until - part.from <= shortest_part) return;
  const auto local = local_face<dim>(face);
  const auto whole = Faces<dim>::integrals(grid_, cell, face);
  SurfacePiece<dim> piece = piece_on(cell, face);
  const double middle = 0.5 * (part.from + part.until);
  piece.weight[static_cast<std::size_t>(local[0])] = 1 - middle;
  piece.weight[static_cast<std::size_t>(local[1])] = middle;
  for (int a = 0; a < dim; ++a) {
    piece.area[a] = (part.until - part.from) * (whole[0][a] + whole[1][a]);
    for (int i = 0; i < cell_nodes<dim>; ++i)
      piece.centre[a] += piece.weight[i] * grid_.node(grid_.cell_nodes_of(cell)[i])[a];
  }
  pieces_.push_back(piece);
}

template <int dim>
void Surface<dim>::add_face_parts(std::size_t cell, int face) {
  const Interval mine = covered(cell, face);
  if (mine.until <= mine.from) return;
  Interval theirs{};
  if (const int other = faces_.neighbour(cell, face); other >= 0) {
    const auto across = static_cast<std::size_t>(other);
    for (int f = 0; f < cell_faces<dim>; ++f)
      if (faces_.neighbour(across, f) == static_cast<int>(cell)) {
        const Interval its = covered(across, f);
        theirs = {1 - its.until, 1 - its.from};
      }
  }
  if (theirs.until <= theirs.from) return add_part(cell, face, mine);
  for (const Interval part : {Interval{mine.from, std::min(mine.until, theirs.from)},
                              Interval{std::max(mine.from, theirs.until), mine.until}})
    if (part.until - part.from > longest_gap)
      add_part(cell, face, part);
    else
      close_gap(cell, face, part);
}

/// Adds the area between the ends of two lines that miss each other to the line that is there.
template <int dim>
void Surface<dim>::close_gap(std::size_t cell, int face, Interval part) {
  if (part.until <= part.from) return;
  const auto across = static_cast<std::size_t>(faces_.neighbour(cell, face));
  const auto whole = Faces<dim>::integrals(grid_, cell, face);
  const int line = line_of_[cell] >= 0 ? line_of_[cell] : line_of_[across];
  for (int a = 0; a < dim; ++a)  // the pieces of lines come first, in the order of the lines
    pieces_[static_cast<std::size_t>(line)].area[a] += (part.until - part.from) * (whole[0][a] + whole[1][a]);
}

/// A whole face of a full cell, in three dimensions.
template <int dim>
void Surface<dim>::add_face(std::size_t cell, int face) {
  const int other = faces_.neighbour(cell, face);
  if (other >= 0 && points_.occupied(static_cast<std::size_t>(other))) return;
  const auto local = local_face<dim>(face);
  const auto whole = Faces<dim>::integrals(grid_, cell, face);
  SurfacePiece<dim> piece = piece_on(cell, face);
  for (std::size_t i = 0; i < local.size(); ++i)
    for (int a = 0; a < dim; ++a) piece.area[a] += whole[i][a];
  const double area = length<dim>(piece.area);
  for (std::size_t i = 0; i < local.size(); ++i) {
    double along = 0;
    for (int a = 0; a < dim; ++a) along += whole[i][a] * piece.area[a];
    const double weight = along / (area * area);
    piece.weight[static_cast<std::size_t>(local[i])] = weight;
    for (int a = 0; a < dim; ++a) piece.centre[a] += weight * grid_.node(grid_.cell_nodes_of(cell)[local[i]])[a];
  }
  pieces_.push_back(piece);
}

template <int dim>
void Surface<dim>::add_line(const Line& line) {
  if constexpr (dim == 2) {
    const Polygon cell = polygon_of(grid_, line.cell);
    std::array<Vector<2>, 2> end{};
    for (std::size_t e = 0; e < 2; ++e)
      for (int a = 0; a < 2; ++a)
        end[e][a] = cell[line.face[e]][a] + line.at[e] * (cell[(line.face[e] + 1) % 4][a] - cell[line.face[e]][a]);
    // Counter-clockwise around the soil the line runs from where a face leaves it to where one enters it.
    SurfacePiece<dim> piece;
    piece.cell = line.cell;
    piece.fill = fill_[line.cell];
    piece.area = {end[1][1] - end[0][1], -(end[1][0] - end[0][0])};
    const double gauss = 1 / std::sqrt(3.0);
    Stencil<dim> s;
    for (double u : {-gauss, gauss}) {
      const double t = 0.5 * (1 + u);
      const Vector<2> x{end[0][0] + t * (end[1][0] - end[0][0]), end[0][1] + t * (end[1][1] - end[0][1])};
      reference_stencil<dim>(grid_.local(line.cell, x), s);
      for (int i = 0; i < 4; ++i) piece.weight[i] += 0.5 * s.value[i];
      for (int a = 0; a < 2; ++a) piece.centre[a] += 0.5 * x[a];
    }
    pieces_.push_back(piece);
  }
}

template <int dim>
bool Surface<dim>::update() {
  if (!measure_cells()) return false;
  pieces_.clear();
  lines_.clear();
  std::ranges::fill(line_of_, -1);
  occupied_.clear();
  each_cell(points_, [&](std::span<const Block* const> blocks) { occupied_.push_back(blocks.front()->cell); });
  if constexpr (dim == 3) {
    for (const std::size_t cell : occupied_)
      for (int face = 0; face < cell_faces<dim>; ++face) add_face(cell, face);
  } else {
    fill_nodes();
    for (const std::size_t cell : occupied_)
      if (fill_[cell] < 1 - full_within && near_surface(cell)) place_line(cell);
    join_lines();
    for (const Line& line : lines_) add_line(line);
    for (const std::size_t cell : occupied_)
      for (int face = 0; face < cell_faces<dim>; ++face) add_face_parts(cell, face);
  }
  return true;
}

template class Surface<2>;
template class Surface<3>;

}  // namespace wetfront::mpm
