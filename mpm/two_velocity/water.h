#pragma once

#include "mpm/two_velocity/cut_surface.h"
#include "mpm/two_velocity/skeleton.h"
#include "mpm/two_velocity/walls.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace wetfront::mpm {

template <int dim>
class MovingLiquid;

/// Water of the occupied cells and the integrals over their points that the two-velocity scheme works with.
/// Everything here is rebuilt from point columns. Volumes of water are at the reference density rho_l [m^dim].
template <int dim>
struct TwoVelocityCells {
  explicit TwoVelocityCells(const Grid<dim>& grid);

  struct PointColumns {
    const Column &volume, &shape, &slope;
    Vector<dim> weight;  ///< rho_l g [Pa/m]
  };
  /// Sums over the points of a block with the stencils they have; `grains` is the volume of solid in it [m^dim].
  void sum(const Grid<dim>& grid, const PointColumns& points, const Block& block, double grains);
  /// Outflow of a cell when u is the nodal flux: sum_i u_i . faces_ci [m^dim/s].
  double flow_out(const Block& block, const Column& u) const {
    double sum = 0;
    for (int i = 0; i < cell_nodes<dim>; ++i)
      for (int a = 0; a < dim; ++a) sum += faces[block.cell][i][a] * u[a][block.nodes[i]];
    return sum;
  }

  std::vector<double> volume;                                      ///< sum_p V_p [m^dim]
  std::vector<double> pores;                                       ///< volume less grains [m^dim]
  std::vector<double> water;                                       ///< sum_p W_p [m^dim]
  std::vector<double> pressure;                                    ///< p_c, the inverse of water/pores [Pa]
  std::vector<double> mobility;                                    ///< k k_rel(p_c)/mu [m2/(Pa s)]
  std::vector<double> stiffness;                                   ///< 4/h^2 (CellGeometry) [1/m2]
  std::vector<std::array<double, cell_nodes<dim>>> share;          ///< sum_p V_p N_i [m^dim]
  std::vector<std::array<Vector<dim>, cell_nodes<dim>>> gradient;  ///< sum_p V_p dN_i/dx [m^(dim-1)]
  /// sum_p V_p dN_i/dx rho_l g.(x_p - centre) [N]: the push of the pressure that hangs below and above the centre in
  /// water at rest. Between parallelograms of one row it cancels; without it water in crooked cells never rests.
  std::vector<std::array<Vector<dim>, cell_nodes<dim>>> hanging;
  /// Integral of dN_i/dx over the cell itself [m^(dim-1)]. The mass balance uses this and not the sum over points:
  /// summed over the cells around an inner node it is zero whatever the points do, so that no water is made or lost.
  std::vector<std::array<Vector<dim>, cell_nodes<dim>>> faces;
  std::vector<Vector<dim>> centre;  ///< sum_p V_p x_p / volume [m]
};

/// What the effects of the two-velocity scheme share: the liquid, the nodal columns and the solve of one node.
///
/// Momentum of both phases together and of the liquid per unit volume of liquid, lumped at the nodes (Lee 2021 Eqs 2
/// and 11, Eqs 1 and 10 with the drag's sign corrected): m_s a_s + m_l a_l = F, and
///   rho_l V_i a_l = F_i - V_i rho_l r_i (v_l - v_s),   F_i = sum_c p_c grad_ci + V_i rho_l g,
///   r_i = (nS)_i mu/(k k_rel)_i / rho_l [1/s].
template <int dim>
struct TwoVelocityWater {
  explicit TwoVelocityWater(const StagePlan<dim>& plan)
      : density(plan.problem.water->density),
        surface(plan.problem.surface.empty() || plan.problem.soils.front().elastic
                    ? nullptr
                    : std::make_unique<CutSurface<dim>>(plan)),
        walls(plan, surface.get()),
        cells(plan.fields.grid) {}

  /// Takes from v_l - v_s what the walls forbid.
  void keep_to_walls(std::size_t i, Velocities<dim>& v) const {
    Vector<dim> change{}, relative{};
    for (int a = 0; a < dim; ++a) change[a] = relative[a] = v.liquid[a] - v.solid[a];
    walls.project(i, relative);
    for (int a = 0; a < dim; ++a) change[a] = relative[a] - change[a];
    skeleton->change_relative(*this, i, change, v);
  }

  double density;                            ///< rho_l [kg/m3]
  std::unique_ptr<CutSurface<dim>> surface;  ///< null where every cell is full
  ImpermeableWalls<dim> walls;
  TwoVelocityCells<dim> cells;
  std::unique_ptr<SkeletonAtNodes<dim>> skeleton;
  MovingSkeleton<dim>* moving = nullptr;  ///< the same where it deforms
  MovingLiquid<dim>* liquid = nullptr;    ///< the liquid of a body that moves
  const Body<dim>* body = nullptr;        ///< the cells that hold points now, where these change
  /// p of a block of points [Pa].
  std::function<double(const Block&)> block_pressure;
  std::vector<double> stiffness;      ///< per cell, w^2 = stiffness nS/(C rho_l) [1/m2] (README.md section 6)
  std::vector<double> limit_of_soil;  ///< the step limit last found, for messages [s]
  /// Nodes and directions in which rain restores the velocity after mapping.
  std::vector<std::pair<std::size_t, Vector<dim>>> unmapped;
  double mapping = 1;  ///< drag's share in the step limit, b there [-]
  /// When the pressures of cells and nodes are found: step VI and VII where points rest; once points have moved to
  /// their new cells (IX) where they do not.
  Phase pressures_in = Phase::pressure, conductivities_in = Phase::saturation;

  Column* volume = nullptr;          ///< V_i = sum_p V_p N_i [m^dim]
  Column* content = nullptr;         ///< (nS)_i = sum_p W_p N_i / V_i, the mass m_l/(rho_l V_i) of Eq. 14 [-]
  Column* velocity = nullptr;        ///< v_l at the start of the step, then the one mapped back (Eq. 14) [m/s]
  Column* velocity_new = nullptr;    ///< v_l from the momentum balance [m/s]
  Column* force = nullptr;           ///< F_i [N]
  Column* mobility = nullptr;        ///< mean k k_rel/mu [m2/(Pa s)]
  Column* pressure = nullptr;        ///< p_i [Pa], carried
  Column* flux = nullptr;            ///< w_i = (nS)_i (v_l - v_s) at the end of the step [m/s], carried
  Column* offset = nullptr;          ///< mean of x_i - centre over the cells of a node [m]
  Column* cell_mobility = nullptr;   ///< mean over the cells of a node of k k_rel(p_c)/mu [m2/(Pa s)]
  Column* flow_volume = nullptr;     ///< of a moving body, V_i of F_i [m^dim]
  Column* solid_velocity = nullptr;  ///< of a moving body, v_s at the end of the step [m/s], carried
  Column* rain_rate = nullptr;       ///< rain that may reach the node in the coming step [m^dim/s], carried
};

}  // namespace wetfront::mpm
