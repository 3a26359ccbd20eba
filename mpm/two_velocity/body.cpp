#include "mpm/two_velocity/body.h"

#include "mpm/boundary/boundary_side.h"

#include <algorithm>
#include <limits>

namespace wetfront::mpm {

namespace {

/// Area vector of a face, out of its cell.
template <int dim>
Vector<dim> area_of(const Grid<dim>& grid, std::size_t cell, int face) {
  Vector<dim> area{};
  for (const Vector<dim>& part : Faces<dim>::integrals(grid, cell, face))
    for (int a = 0; a < dim; ++a) area[a] += part[a];
  return area;
}

}  // namespace

template <int dim>
Body<dim>::Body(const StagePlan<dim>& plan)
    : plan_(plan),
      faces_(plan.fields.grid, plan.problem.mesh),
      up_(upward(plan.problem)),
      occupied_(plan.fields.grid.cell_count()),
      at_surface_(plan.fields.grid.cell_count()),
      open_(plan.fields.grid.cell_count()),
      was_surface_(plan.fields.grid.cell_count()),
      looked_at_(plan.fields.grid.cell_count()),
      cells_around_(plan.fields.grid.node_count()) {
  const auto& sides = plan.problem.mesh.sides;
  for (std::size_t k = 0; k < plan.problem.water_boundary.size(); ++k)
    if (const auto* rain = std::get_if<RainSide>(&plan.problem.water_boundary[k])) {
      const auto side =
          std::find_if(sides.begin(), sides.end(), [rain](const auto& s) { return s.name == rain->side; });
      rain_.push_back(static_cast<int>(k));
      const auto& intensity = rain->rain.intensity;
      seeps_.push_back(std::none_of(intensity.begin(), intensity.end(), [](double i) { return i > 0; }) ? 1 : 0);
      side_of_rain_.push_back(rain->side == free_surface ? -1 : static_cast<int>(side - sides.begin()));
    }
  update();
}

template <int dim>
bool Body<dim>::update() {
  const auto& points = plan_.fields.points;
  if (version_ == points.version()) return false;
  const bool first = version_ < 0;
  version_ = points.version();
  changed_.clear();
  cells_before_.swap(cells_);
  cells_.clear();
  constexpr char listed = 2;
  for (const Block& block : points.blocks()) {
    if (occupied_[block.cell] == 0) change(block.cell, true);
    if (occupied_[block.cell] == listed) continue;  // two soils in one cell
    occupied_[block.cell] = listed;
    cells_.push_back(block.cell);
  }
  if (plan_.problem.soils.size() > 1) std::ranges::sort(cells_);
  for (std::size_t cell : cells_before_)
    if (occupied_[cell] != listed) change(cell, false);
  for (std::size_t cell : cells_) occupied_[cell] = 1;
  if (changed_.empty() && !first) return false;
  find_nodes();
  find_outer();
  return true;
}

/// Of a cell that has come or gone: its faces and those of the cells across.
template <int dim>
void Body<dim>::change(std::size_t cell, bool occupied) {
  occupied_[cell] = occupied ? 1 : 0;
  changed_.push_back(cell);
  const int* nodes = plan_.fields.grid.cell_nodes_of(cell);
  for (int i = 0; i < cell_nodes<dim>; ++i) cells_around_[static_cast<std::size_t>(nodes[i])] += occupied ? 1 : -1;
  looked_at_[cell] = 1;
  for (int f = 0; f < cell_faces<dim>; ++f)
    if (const int across = faces_.neighbour(cell, f); across >= 0) looked_at_[static_cast<std::size_t>(across)] = 1;
}

template <int dim>
void Body<dim>::find_nodes() {
  left_nodes_.clear();
  for (int i : nodes_)
    if (cells_around_[static_cast<std::size_t>(i)] == 0) left_nodes_.push_back(i);
  nodes_.clear();
  for (std::size_t i = 0; i < cells_around_.size(); ++i)
    if (cells_around_[i] != 0) nodes_.push_back(static_cast<int>(i));
  node_runs_.clear();
  for (int i : nodes_) {
    const auto node = static_cast<std::size_t>(i);
    if (node_runs_.empty() || node_runs_.back().last != node) node_runs_.push_back({node, node});
    node_runs_.back().last = node + 1;
  }
}

template <int dim>
void Body<dim>::find_outer() {
  outer_count_ = 0;
  for (std::size_t cell : cells_) {
    if (looked_at_[cell] == 0) continue;
    const std::size_t before = outer_count_;
    for (int f = 0; f < cell_faces<dim>; ++f) {
      const int across = faces_.neighbour(cell, f);
      if (across >= 0 && occupied_[static_cast<std::size_t>(across)] != 0) continue;
      if (outer_count_ == outer_.size()) outer_.emplace_back().rains.reserve(rain_.size());
      OuterFace& outer = outer_[outer_count_++];
      outer.cell = cell, outer.face = f, outer.border = across < 0;
      outer.rains.clear();
      if (!rain_.empty()) rain_on(outer);
    }
    if (outer_count_ == before) looked_at_[cell] = 0;
  }
  if (std::find(side_of_rain_.begin(), side_of_rain_.end(), -1) != side_of_rain_.end()) shade();
  find_surface();
}

template <int dim>
void Body<dim>::find_surface() {
  surface_before_.swap(surface_cells_);
  for (std::size_t cell : surface_before_) was_surface_[cell] = 1;
  for (std::size_t cell : near_) at_surface_[cell] = open_[cell] = 0;
  surface_cells_.clear();
  near_.clear();
  for (const OuterFace& face : outer()) {
    if (!face.border || !face.rains.empty()) open_[face.cell] = 1;
    if (open_[face.cell] != 0 && at_surface_[face.cell] == 0) {
      at_surface_[face.cell] = surface_itself;
      surface_cells_.push_back(face.cell);
      near_.push_back(face.cell);
    }
  }
  for (std::size_t cell : surface_cells_)
    if (was_surface_[cell] == 0) changed_.push_back(cell);
  for (std::size_t cell : surface_before_) {
    was_surface_[cell] = 0;
    if (!at_surface(cell)) changed_.push_back(cell);
  }
  for (std::size_t cell : surface_cells_)
    for (int f = 0; f < cell_faces<dim>; ++f) {
      const int across = faces_.neighbour(cell, f);
      if (!occupied(across) || at_surface_[static_cast<std::size_t>(across)] != 0) continue;
      at_surface_[static_cast<std::size_t>(across)] = next_to_surface;
      near_.push_back(static_cast<std::size_t>(across));
    }
}

/// A named side rains on its own faces; rain on the free surface on those in front of empty cells that see the sky.
template <int dim>
void Body<dim>::rain_on(OuterFace& outer) const {
  const int side = outer.border ? faces_.side(outer.cell, outer.face) : -1;
  for (std::size_t k = 0; k < rain_.size(); ++k) {
    if (side_of_rain_[k] >= 0) {
      if (outer.border && side == side_of_rain_[k]) outer.rains.push_back(rain_[k]);
      continue;
    }
    if (outer.border) continue;
    const Vector<dim> area = area_of<dim>(plan_.fields.grid, outer.cell, outer.face);
    // Within a degree of the vertical no rain falls on it; a seepage face may face any way.
    if (seeps_[k] != 0 || dot<dim>(area, up_) > 0.02 * length<dim>(area)) outer.rains.push_back(rain_[k]);
  }
}

/// Takes the rain from faces that other faces lie above: soil that has come to rest above soil keeps it dry. (Two
/// dimensions; where faces share the centre of one of them.)
template <int dim>
void Body<dim>::shade() {
  if constexpr (dim == 2) {
    roofs_.clear();
    const auto& grid = plan_.fields.grid;
    for (OuterFace& outer : std::span(outer_.data(), outer_count_)) {
      if (outer.border || outer.rains.empty()) continue;
      double at[2], height = 0;
      for (int k = 0; k < 2; ++k) {
        const Vector<dim>& x = grid.node(grid.cell_nodes_of(outer.cell)[local_face<dim>(outer.face)[k]]);
        at[k] = up_[1] * x[0] - up_[0] * x[1];
        height += 0.5 * dot<dim>(x, up_);
      }
      roofs_.push_back({std::min(at[0], at[1]), std::max(at[0], at[1]), height, &outer});
    }
    std::sort(roofs_.begin(), roofs_.end(), [](const Roof& a, const Roof& b) { return a.from < b.from; });
    double widest = 0;
    for (const Roof& roof : roofs_) widest = std::max(widest, roof.until - roof.from);
    for (std::size_t k = 0; k < roofs_.size(); ++k) {
      const double middle = 0.5 * (roofs_[k].from + roofs_[k].until);
      for (std::size_t m = k; m-- > 0 && roofs_[m].from > middle - widest;)
        if (roofs_[m].until > middle && roofs_[m].height > roofs_[k].height) roofs_[k].face->rains.clear();
      for (std::size_t m = k + 1; m < roofs_.size() && roofs_[m].from < middle; ++m)
        if (roofs_[m].until > middle && roofs_[m].height > roofs_[k].height) roofs_[k].face->rains.clear();
    }
  }
}

template class Body<2>;
template class Body<3>;

}  // namespace wetfront::mpm
