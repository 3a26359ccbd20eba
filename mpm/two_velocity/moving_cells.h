#pragma once

#include "mpm/laws/tabulated.h"
#include "mpm/two_velocity/body.h"
#include "mpm/two_velocity/cell_geometry.h"
#include "mpm/two_velocity/content_table.h"
#include "mpm/two_velocity/lane_cell.h"

#include <vector>

namespace wetfront::mpm {

/// The laws of a soil as the kernels of a moving body evaluate them: by tables, of one type for all soils.
struct LiquidLaws {
  TabulatedContent content;
  TabulatedPermeability permeability;
  double saturated_mobility;  ///< k/mu [m2/(Pa s)]
  double grain_density;       ///< kg/m3
  double pressure_scale;      ///< Pa, of the retention curve
  double driest;              ///< content at a thousand times that suction [-]

  double mobility(double p) const { return saturated_mobility * permeability.at(-p).value; }
};

/// A vector for each node of a cell, axis by axis.
template <int dim>
using NodalVectors = std::array<std::array<double, cell_nodes<dim>>, dim>;

/// What a block of points, those of one soil in one cell, holds of the liquid.
template <int dim>
struct LiquidBlock {
  double volume = 0;         ///< sum_p V_p [m^dim]
  double pores = 0;          ///< volume less grains [m^dim]
  double water = 0;          ///< sum_p W_p [m^dim]
  double pressure = 0;       ///< e^-1(water/pores) [Pa]
  double mobility = 0;       ///< k k_rel(p)/mu [m2/(Pa s)]
  double saturation = 0;     ///< S [-]
  double slope = 0;          ///< de/dp at the pressure [1/Pa]
  double content = 0;        ///< water/pores of the block, or of its group [-]
  double fill = 1;           ///< volume over that of the cell; of a group, over its host's [-]
  int group = -1;            ///< LiquidGroup; -1: none
  double part = 1;           ///< of the volume of all points of its cell [-]
  Vector<dim> centre{};      ///< sum_p V_p x_p / volume [m]
  NodalVectors<dim> push{};  ///< sum_p V_p grad N_i [m^(dim-1)]
};

/// A cell at the surface that is hardly filled shares one pressure with a fuller cell beside it: what flows through its
/// faces is large against what it stores, and its own pressure would ask for steps as short as it is thin.
struct LiquidGroup {
  std::vector<std::size_t> blocks;  ///< by their places, the host first
  double volume = 0;                ///< m^dim
  double pores = 0, water = 0;      ///< m^dim
};

/// Sums over the points around a node, one after the other in memory.
template <int dim>
struct LiquidNode {
  double volume = 0;       ///< sum_p V_p N_i [m^dim]
  double water = 0;        ///< sum_p W_p N_i [m^dim]
  Vector<dim> momentum{};  ///< sum_p W_p (v_l - v_s) N_i
  double pressure = 0;     ///< sum of share * p
  Vector<dim> centre{};    ///< sum of share * x_c
  double mobility = 0;     ///< sum of share * K(p_c)
};

}  // namespace wetfront::mpm
