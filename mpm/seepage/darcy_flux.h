#pragma once

#include "mpm/grid/material_points.h"
#include "mpm/seepage/cell_permeability.h"
#include "mpm/seepage/conduction.h"
#include "mpm/seepage/nodal_water.h"

namespace wetfront::mpm {

/// Darcy's flux of the points of a block: R_i += V_p grad N_i . q_p, with its derivative,
/// q_p = -(k k_rel/mu) T (grad p - rho g), or with inertia as LiquidInertia says.
template <int dim, class Driving, class Tensor, class Inertia>
struct DarcyFlux {
  static constexpr int n = cell_nodes<dim>;

  NodalWater<dim>& water;
  const std::vector<int>& slots;        ///< matrix entries of every cell
  const std::vector<double>& mobility;  ///< k/mu of the blocks' soil in every cell [m2/(Pa s)]
  const std::vector<double>& reach;     ///< half the box of every point, in local coordinates
  const Column &volume, &value, &gradient;
  TabulatedPermeability law;
  Driving driving;
  Tensor tensor;
  Inertia inertia;

  /// One point: gradients along the principal axes, what drives it, k_rel.
  struct Point {
    std::array<double, n> shape{};
    std::array<Vector<dim>, n> grad{};
    Vector<dim> drive{};
    typename CellPermeability<dim>::Value relative;
  };

  Point point(const std::array<double, n>& pressure, const CellPermeability<dim>& permeability, std::size_t q) const {
    Point here;
    Vector<dim> slope{};
    double p = 0;
    for (int i = 0; i < n; ++i) {
      here.shape[i] = value[i][q];
      p += here.shape[i] * pressure[i];
      for (int a = 0; a < dim; ++a) {
        here.grad[i][a] = gradient[i * dim + a][q];
        slope[a] += here.grad[i][a] * pressure[i];
      }
      here.grad[i] = tensor.to_axes(here.grad[i]);
    }
    driving(slope);
    inertia.drive(q, slope);
    here.drive = tensor.to_axes(slope);
    here.relative = permeability.at(here.shape, p, reach[q]);
    return here;
  }

  std::array<double, n> pressures(const Block& block) const {
    std::array<double, n> pressure{};
    for (int i = 0; i < n; ++i) pressure[i] = (*water.trial)[0][block.nodes[i]];
    return pressure;
  }

  void operator()(const Block& block) const {
    std::array<double, n> flow{};
    std::array<double, n * n> slope{};
    const std::array<double, n> pressure = pressures(block);
    const CellPermeability<dim> permeability(law, pressure);
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      const Point here = point(pressure, permeability, q);
      const auto flux = inertia.at(q, water.dt, tensor);
      std::array<double, n> by_mobility{};  // d(flow of node i)/d k_rel
      std::array<Vector<dim>, n> weighted{};
      for (int a = 0; a < dim; ++a) {
        const double scale = tensor.factor(a) * mobility[block.cell];
        const AxisFlux axis = flux(a, scale * here.relative.value);
        const double along = axis.memory - axis.mobility * here.drive[a];
        const double change = scale * (axis.memory_slope - axis.mobility_slope * here.drive[a]);
        for (int i = 0; i < n; ++i) {
          const double g = volume[0][q] * here.grad[i][a];
          flow[i] += g * along;
          by_mobility[i] += g * change;
          weighted[i][a] = g * axis.mobility;
        }
      }
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          double stiffness = 0;
          for (int a = 0; a < dim; ++a) stiffness += weighted[i][a] * here.grad[j][a];
          slope[i * n + j] += by_mobility[i] * here.relative.slope[j] - stiffness;
        }
    }
    const auto matrix = water.matrix->values();
    for (int i = 0; i < n; ++i) (*water.inflow)[0][block.nodes[i]] += flow[i];
    for (int k = 0; k < n * n; ++k) matrix[static_cast<std::size_t>(slots[block.cell * n * n + k])] += slope[k];
  }

  /// q of the points at the trial pressures: what the next step's inertia remembers.
  void remember(const Block& block, Column& memory) const {
    const std::array<double, n> pressure = pressures(block);
    const CellPermeability<dim> permeability(law, pressure);
    for (std::size_t q = block.first; q < block.first + block.count; ++q) {
      const Point here = point(pressure, permeability, q);
      const auto flux = inertia.at(q, water.dt, tensor);
      Vector<dim> along{};
      for (int a = 0; a < dim; ++a) {
        const AxisFlux axis = flux(a, tensor.factor(a) * mobility[block.cell] * here.relative.value);
        along[a] = axis.memory - axis.mobility * here.drive[a];
      }
      along = tensor.from_axes(along);
      for (int a = 0; a < dim; ++a) memory[a][q] = along[a];
    }
  }
};

}  // namespace wetfront::mpm
