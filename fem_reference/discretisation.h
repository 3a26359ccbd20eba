#pragma once

#include "fem_reference/richards_problem.h"

#include <memory>
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

/// Everything the solver needs of mesh and finite element, in flat arrays and without the dimension as a type.
/// Filled by the template of discretise.cpp, the only unit that sees deal.II.
/// Degrees of freedom are numbered upwards (by elevation, then by the other coordinates).
struct Discretisation {
  int dim = 0;
  int dof_count = 0;
  int cell_count = 0;
  int dofs_per_cell = 0;
  int points_per_cell = 0;              ///< Gauss points, (degree + 1)^dim
  std::vector<int> cell_dofs;           ///< [cell][local dof]
  std::vector<int> cell_soil;           ///< [cell]
  std::vector<int> mesh_cell;           ///< [cell] -> cell of RichardsProblem::mesh that it is, or lies in
  std::vector<double> shape;            ///< [point][local dof], the same in every cell
  std::vector<double> gradient;         ///< [cell][point][local dof][axis], 1/m
  std::vector<double> weight;           ///< [cell][point], m^dim
  std::vector<double> centre_shape;     ///< [local dof]
  std::vector<meshes::Point> position;  ///< [dof]
  std::vector<int> node_dof;            ///< mesh node -> dof
  std::vector<StorageShare> storage;
  std::vector<std::vector<SideShare>> sides;  ///< per boundary condition of the problem
  std::vector<Place> gauges;                  ///< per gauge of the problem
  std::vector<double> initial_head;           ///< [dof], m
};

/// Throws std::invalid_argument when a gauge lies outside the mesh or a side's face is not on its boundary.
Discretisation discretise(const RichardsProblem& problem);

}  // namespace wetfront::fem_reference
