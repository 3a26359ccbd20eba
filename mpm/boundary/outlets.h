#pragma once

#include "mpm/boundary/surface.h"
#include "mpm/plan/stage_plan.h"

#include <string>
#include <vector>

namespace wetfront::mpm {

/// A place where water can pass the border of the soil, with the shape functions there. Faces that coincide with cell
/// faces are lumped at their nodes (one node, weight 1: no mode of the surface pressures escapes); a piece that cuts
/// through a cell acts at its centre, with N_i(x_s) of all the cell's nodes.
template <int dim>
struct Outlet {
  std::array<int, cell_nodes<dim>> node{};
  std::array<double, cell_nodes<dim>> weight{};  ///< sum 1
  int count = 0;                                 ///< of nodes
  int piece = -1;                                ///< of the surface, where it acts by itself; -1: lumped at its node
  Vector<dim> centre{};                          ///< x_s [m]
  Vector<dim> area{};                            ///< outwards [m^(dim-1)]
  double size = 0;                               ///< sum of |area| of its parts
  double open = 0, hidden = 0;                   ///< horizontal areas of the parts that see the sky, face the ground
  double shaded = 0;                             ///< the same of parts that face upwards with soil above (2-D)
  std::size_t cell = 0;                          ///< the soil behind
  int region = 0;   ///< its soil: of the point nearest to the piece (the lowest index where several meet)
  double film = 0;  ///< conductance of the surface film of that soil, 1e4 k/(mu h) [m/(s Pa)], largest k where two meet

  double at(const double* nodal) const {
    double sum = 0;
    for (int i = 0; i < count; ++i)
      sum += weight[static_cast<std::size_t>(i)] * nodal[node[static_cast<std::size_t>(i)]];
    return sum;
  }
};

/// The outlets of a named side of the mesh or of the free surface, as the scene's RainScheme says. `who` and `origin`
/// name the entry that asks, for the message. Throws CannotPlan when there is no such side or no soil behind it.
template <int dim>
std::vector<Outlet<dim>> outlets(const StagePlan<dim>& plan, const Surface<dim>& surface, const std::string& side,
                                 const std::string& who, const Origin& origin);

/// Throws CannotPlan when rain (or evaporation) asked for on a side cannot act: it faces nowhere up or some of it down,
/// soil lies above it, or part of the surface that it would reach belongs to no condition. In a body that `has_moved`
/// soil may lie above soil: rain falls on the upper one.
template <int dim>
void check_rain(const StagePlan<dim>& plan, const Surface<dim>& surface, const std::vector<Outlet<dim>>& outlets,
                const std::string& side, bool has_moved, const Origin& origin);

/// Conductance of the surface film per k/(mu h). physics.md section 3: insensitive over six decades. A flux q through
/// the film leaves rho g h (q/K_s)/1e4 of pressure: 0.6 Pa on the largest cells of the flume. (1e3 left 5.6 Pa there;
/// with 1e5 saturated soil under rain that stops and starts found no step.)
constexpr double film_conductance = 1e4;

}  // namespace wetfront::mpm
