#include "mpm/two_velocity/cut_surface.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/laws/soil_water.h"
#include "mpm/two_velocity/content.h"
#include "mpm/two_velocity/water.h"

#include <algorithm>
#include <cmath>

namespace wetfront::mpm {

namespace {

/// From the centre of the soil in the cell to the surface.
template <int dim>
Vector<dim> outwards(const TwoVelocityWater<dim>& water, const typename CutSurface<dim>::Piece& piece) {
  Vector<dim> way = piece.centre;
  for (int a = 0; a < dim; ++a) way[a] -= water.cells.centre[piece.cell][a];
  return way;
}

}  // namespace

template <int dim>
CutSurface<dim>::CutSurface(const StagePlan<dim>& plan) : plan_(plan) {
  Surface<dim> surface(plan.fields.grid, plan.fields.points, plan.problem.mesh);
  surface.update();
  const Vector<dim> up = upward(plan.problem);
  for (const SurfacePiece<dim>& found : surface.pieces()) {
    if (found.border) {
      std::vector<int> face;
      for (int local : local_face<dim>(found.face)) face.push_back(plan.fields.grid.cell_nodes_of(found.cell)[local]);
      std::sort(face.begin(), face.end());
      wet_.insert(face);
      continue;
    }
    Piece piece{found.cell,
                found.centre,
                found.area,
                std::sqrt(dot<dim>(found.area, found.area)),
                std::max(0.0, dot<dim>(found.area, up)),
                found.weight};
    pieces_.push_back(piece);
  }
  for (const auto& boundary : plan.problem.water_boundary)
    if (const auto* rain = std::get_if<RainSide>(&boundary); rain != nullptr && rain->side == free_surface)
      rains_.push_back(*rain);
  for (const Soil& soil : plan.problem.soils)
    with_soil_water(soil, *plan.problem.water, [&](const auto& laws) {
      content_.emplace_back(
          [law = WaterContent(laws.curve, plan.problem.water->bulk_modulus)](double p) { return law.value(p); });
    });
}

template <int dim>
double CutSurface<dim>::intensity(double time) const {
  double sum = 0;
  for (const RainSide& rain : rains_) sum += meshes::intensity_after(rain.rain, time);
  return sum;
}

template <int dim>
double CutSurface<dim>::rain_on(std::size_t cell, double time) const {
  double area = 0;
  for (const Piece& piece : pieces_)
    if (piece.cell == cell) area += piece.open;
  return area > 0 ? area * intensity(time) : 0;
}

template <int dim>
void CutSurface<dim>::attach(TwoVelocityWater<dim>& water) const {
  auto& cells = water.cells;
  const auto& grid = plan_.fields.grid;
  std::vector<Vector<dim>> left(grid.node_count());
  std::vector<int> cut_cells_at(grid.node_count());
  std::set<std::size_t> cut;
  for (const Piece& piece : pieces_) cut.insert(piece.cell);
  // Of a cell that is cut only the part with soil has faces: the integral over its points.
  for (std::size_t c : cut) {
    cells.faces[c] = cells.gradient[c];
    cells.hanging[c] = {};  // push() carries the pressure from the centre to the surface
  }
  for (const Piece& piece : pieces_)
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a) {
        cells.faces[piece.cell][i][a] -= piece.weight[static_cast<std::size_t>(i)] * piece.area[a];
        cells.gradient[piece.cell][i][a] -= piece.weight[static_cast<std::size_t>(i)] * piece.area[a];
      }
  for (const Block& block : plan_.fields.points.blocks())
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      for (int a = 0; a < dim; ++a) left[block.nodes[i]][a] += cells.faces[block.cell][i][a];
      cut_cells_at[block.nodes[i]] += cut.contains(block.cell) ? 1 : 0;
    }
  for (std::size_t i = 0; i < left.size(); ++i) water.walls.project(i, left[i]);
  for (const Block& block : plan_.fields.points.blocks())
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim && cut.contains(block.cell); ++a)
        cells.faces[block.cell][i][a] -= left[block.nodes[i]][a] / cut_cells_at[block.nodes[i]];
}

/// p_s - p_c. Along the way d from the cell's centre, grad p = rho g - w/K with w.n = -I; the soil at the surface
/// conducts the rain at a unit gradient at least, however dry the mean of the cell is.
template <int dim>
double CutSurface<dim>::excess_pressure(const TwoVelocityWater<dim>& water, const Piece& piece,
                                        double intensity) const {
  const Vector<dim> way = outwards<dim>(water, piece);
  const double height = dot<dim>(way, piece.area) / piece.size,
               weight = water.density * dot<dim>(way, plan_.problem.gravity);
  const double flux = intensity * piece.open / piece.size;
  double gravity = std::sqrt(dot<dim>(plan_.problem.gravity, plan_.problem.gravity)) * water.density;
  const double driven = gravity > 0 ? std::min(flux / water.cells.mobility[piece.cell], gravity) : 0.0;
  return std::min(weight + height * driven, -water.cells.pressure[piece.cell]);
}

template <int dim>
void CutSurface<dim>::push(TwoVelocityWater<dim>& water, double time) const {
  const double rain = intensity(time);
  for (const Piece& piece : pieces_) {
    const double excess = excess_pressure(water, piece, rain);
    const int* nodes = plan_.fields.grid.cell_nodes_of(piece.cell);
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a)
        (*water.force)[a][nodes[i]] -= excess * piece.weight[static_cast<std::size_t>(i)] * piece.area[a];
  }
}

/// Water of the cell at p_s = 0 [m^dim], when what leaves it inwards comes through the surface:
/// p_c = -d.(rho g) - d.n w/K_s.
template <int dim>
double CutSurface<dim>::most_water(const TwoVelocityWater<dim>& water, const Piece& piece) const {
  const auto region = static_cast<std::size_t>(plan_.fields.grid.region(piece.cell));
  const Soil& soil = plan_.problem.soils[region];
  const Vector<dim> way = outwards<dim>(water, piece);
  const Block block{piece.cell, plan_.fields.grid.cell_nodes_of(piece.cell), 0, 0};
  const double through = water.cells.flow_out(block, *water.flux) / piece.size;
  const double loss = through * plan_.problem.water->viscosity / soil.intrinsic_permeability;
  const double p =
      -water.density * dot<dim>(way, plan_.problem.gravity) - dot<dim>(way, piece.area) / piece.size * loss;
  return water.cells.pores[piece.cell] * content_[region](p);
}

template <int dim>
void CutSurface<dim>::rain(const TwoVelocityWater<dim>& water, double time, double dt,
                           const std::function<double(std::size_t)>& held,
                           const std::function<void(std::size_t, double)>& change) {
  const double now = intensity(time);
  for (Piece& piece : pieces_) {
    piece.asked = now * piece.open * dt;
    const double surplus = std::max(0.0, held(piece.cell) + piece.asked - most_water(water, piece));
    piece.taken = std::max(0.0, piece.asked - surplus);
    piece.seeped = std::max(0.0, surplus - piece.asked);
    change(piece.cell, piece.taken - piece.seeped);
  }
}

template class CutSurface<2>;
template class CutSurface<3>;

}  // namespace wetfront::mpm
