#pragma once

#include "fem_reference/ranks/ranks.h"
#include "fem_reference/richards_problem.h"

#include <array>
#include <string>
#include <vector>

namespace wetfront::fem_reference {

/// A share of the lumped mass matrix: one per degree of freedom and soil around it.
struct StorageShare {
  int dof;
  int soil;
  double volume;  ///< [m, m2, m3]
};

/// A share of a lumped side: one per degree of freedom, face and soil.
struct SideShare {
  int dof;
  int soil;
  double area;             ///< [1, m, m2]
  double horizontal_area;  ///< projected on the horizontal, positive where the outward normal points up, else negative
  meshes::Point normal_area;  ///< integral of the outward normal, times the conductivity factor of the cell behind it
};

/// Where a place lies: the cell and the values of its shape functions there.
struct Place {
  int cell;
  std::vector<double> shape;
};

/// The part of a mesh cell that a refined cell is: `low` to `low + 2^(levels - level)` of the lattice that `levels`
/// halvings make of the mesh cell, 2^levels steps per axis of its unit cell (deal.II's axes).
struct Box {
  int mesh_cell;
  int level;  ///< halvings
  std::array<int, 3> low;
  auto operator<=>(const Box&) const = default;
};

/// Everything the solver needs of mesh and finite element, in flat arrays and without the dimension as a type.
/// Filled by Space (space.cpp), the only unit that sees deal.II.
/// Degrees of freedom are numbered upwards (by elevation, then by the other coordinates).
///
/// A hanging node is no degree of freedom: in each of its cells the vertex of the parent's edge or face that the cell
/// has not takes its place, so a cell has dofs_per_cell unknowns still, with shape functions of their own (README, Eq
/// 6). Cells of equal constraints share a pattern; pattern 0 is that of a cell without.
struct Discretisation {
  int dim = 0;
  int dof_count = 0;  ///< unknowns; on several ranks those that this rank owns
  int cell_count = 0;
  int dofs_per_cell = 0;
  int points_per_cell = 0;              ///< Gauss points, (degree + 1)^dim
  int levels = 0;                       ///< halvings that Box::low counts in
  std::vector<int> cell_dofs;           ///< [cell][local dof]
  std::vector<int> cell_soil;           ///< [cell]
  std::vector<int> mesh_cell;           ///< [cell] -> cell of RichardsProblem::mesh that it is, or lies in
  std::vector<Box> box;                 ///< [cell]
  std::vector<int> cell_pattern;        ///< [cell]
  std::vector<double> shape;            ///< [pattern][point][local dof]
  std::vector<double> centre_shape;     ///< [pattern][local dof]
  std::vector<double> corner_shape;     ///< [pattern][corner, deal.II's order][local dof]
  std::vector<double> corner_volume;    ///< [cell][corner]: the corner's share of the lumped mass, degree 1 only
  std::vector<double> gradient;         ///< [cell][point][local dof][axis], 1/m
  std::vector<double> weight;           ///< [cell][point], m^dim
  std::vector<meshes::Point> position;  ///< [dof, then ghost]
  std::vector<int> node_dof;            ///< mesh node -> dof
  std::vector<int> mesh_corner;         ///< [mesh cell][corner, deal.II's order] -> mesh node
  std::vector<StorageShare> storage;
  std::vector<std::vector<SideShare>> sides;  ///< per boundary condition of the problem
  std::vector<Place> gauges;                  ///< per gauge of the problem
  std::vector<double> initial_head;           ///< [dof], m
  Ranks ranks;  ///< with the other ranks of the solve; its ghosts are numbered behind the unknowns

  int corners() const { return 1 << dim; }
  const int* dofs_of(int cell) const { return &cell_dofs[static_cast<std::size_t>(cell) * dofs_per_cell]; }
  /// [point][local dof] of one cell.
  const double* shape_of(int cell) const {
    return &shape[static_cast<std::size_t>(cell_pattern[cell]) * points_per_cell * dofs_per_cell];
  }
  /// [local dof]
  const double* centre_shape_of(int cell) const {
    return &centre_shape[static_cast<std::size_t>(cell_pattern[cell]) * dofs_per_cell];
  }
  /// [corner][local dof]
  const double* corner_shape_of(int cell) const {
    return &corner_shape[static_cast<std::size_t>(cell_pattern[cell]) * corners() * dofs_per_cell];
  }
};

/// Of a solve on several ranks each has the cells that touch unknowns of its own, so that it can complete the equations
/// of these; cell_dofs and node_dof then name ghosts too (numbered from dof_count on), nothing else does. A node, or a
/// gauge, of another rank's cells has -1.

/// The discretisation of the problem's own mesh. Throws std::invalid_argument when a gauge lies outside the mesh or
/// periodic sides do not match.
Discretisation discretise(const RichardsProblem& problem);

}  // namespace wetfront::fem_reference
