#include "mpm/laws/soil_water.h"
#include "mpm/laws/stress_law.h"
#include "mpm/two_velocity/content.h"
#include "mpm/two_velocity/two_velocity.h"

#include <algorithm>
#include <cmath>
#include <limits>

/// Step VII of the two-velocity scheme (pressures and conductivities of the nodes) and its step limit.
namespace wetfront::mpm {

namespace {

/// A step may grow by this factor over the last one, so that the look-ahead of the limit (below) cannot be outrun.
constexpr double growth = 1.5;
/// Steps that the limit looks ahead at the present rate of filling.
constexpr double steps_ahead = 4;

/// Largest stable step of symplectic Euler with implicit drag r on an oscillator omega: omega^2 dt^2 <= 4 + 2 r dt
/// (README.md section 6).
double stable_step(double drag, double omega_squared) {
  return (drag + std::sqrt(drag * drag + 4 * omega_squared)) / omega_squared;
}

}  // namespace

template <int dim>
void TwoVelocityLiquid<dim>::add_state(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  auto& points = plan.fields.points;
  const std::size_t nodes = plan.fields.grid.node_count();
  const Vector<dim> weight = liquid_weight(plan);
  // Mean of the cells' pressures, carried hydrostatically from their centres to the node: the shift cancels inside a
  // uniform mesh and is exact at an impermeable boundary at rest.
  const auto pressures = [&w, &points, weight, nodes] {
    w.pressure->fill(0);
    w.mobility->fill(0);
    w.cell_mobility->fill(0);
    for (const Block& block : points.blocks())
      for (int i = 0; i < cell_nodes<dim>; ++i)
        (*w.pressure)[0][block.nodes[i]] += w.cells.share[block.cell][i] * w.cells.pressure[block.cell];
    for (std::size_t i = 0; i < nodes; ++i) {
      if (!((*w.volume)[0][i] > 0)) continue;
      double& p = (*w.pressure)[0][i];
      p /= (*w.volume)[0][i];
      for (int a = 0; a < dim; ++a) p += weight[a] * (*w.offset)[a][i];
    }
  };
  plan.add(w.conductivities_in, "nodal pressure", pressures);
  plan.at_ready(pressures);
  for (std::size_t r = 0; r < plan.problem.soils.size(); ++r) {
    const Soil& soil = plan.problem.soils[r];
    with_soil_water(soil, *plan.problem.water, [&](const auto& laws) {
      const auto conductivity = [laws](double p) {
        return laws.saturated_mobility * laws.permeability(laws.curve, -p).value;
      };
      // Simpson's mean of K between the centres of the cells, the node between them: 1/3 cells, 2/3 node. Nodes are
      // evaluated once per soil, not once per cell.
      std::vector<double> at_node(nodes);
      const auto mean = [&w, &points, r, conductivity, at_node]() mutable {
        constexpr double unknown = -1;
        std::fill(at_node.begin(), at_node.end(), unknown);
        for (const Block& block : points.blocks(static_cast<int>(r))) {
          const double cell = conductivity(w.cells.pressure[block.cell]);
          for (int i = 0; i < cell_nodes<dim>; ++i) {
            const auto node = static_cast<std::size_t>(block.nodes[i]);
            if (at_node[node] == unknown) at_node[node] = conductivity((*w.pressure)[0][node]);
            const double part = w.cells.share[block.cell][i] / (*w.volume)[0][node];
            (*w.cell_mobility)[0][node] += part * cell;
            (*w.mobility)[0][node] += part * (cell + 2 * at_node[node]) / 3;
          }
        }
      };
      plan.add(w.conductivities_in, "conductivity [" + soil.name + "]", mean);
      plan.at_ready(mean);
    });
  }
}

template <int dim>
void TwoVelocityLiquid<dim>::add_limits(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  for (std::size_t r = 0; r < plan.problem.soils.size(); ++r) {
    const Soil& soil = plan.problem.soils[r];
    with_soil_water(soil, *plan.problem.water, [&](const auto& laws) {
      const WaterContent law(laws.curve, plan.problem.water->bulk_modulus);
      const auto of_cell = [this, &w, law](const Block& block) {
        const std::size_t c = block.cell;
        const TwoVelocityCells<dim>& cells = w.cells;
        double mobility = 0, rain = 0;
        for (int i = 0; i < cell_nodes<dim>; ++i) {
          const auto node = static_cast<std::size_t>(block.nodes[i]);
          if (!w.walls.closed(node)) mobility = std::max(mobility, (*w.mobility)[0][node]);
          rain += (*w.rain_rate)[0][node] * cells.share[c][i] / (*w.volume)[0][node];
        }
        const double wet = cells.water[c] / cells.volume[c], pores = cells.pores[c] / cells.volume[c];
        const double drag = wet / (mobility * w.density);
        const auto stable = [&](double slope) {
          return stable_step(drag, 4 / (cells.size[c] * cells.size[c]) * wet / (pores * slope) / w.density);
        };
        const double now = stable(law.slope(cells.pressure[c]));
        // A cell near saturation stiffens 1e4-fold within a step: the limit is that of the stiffest state it can reach.
        const double last = (*steps_)[0][0];
        const double rate = std::max(std::abs(cells.flow_out(block, *w.flux)), rain) / cells.pores[c];
        const double ahead = cells.water[c] / cells.pores[c] + steps_ahead * rate * (last > 0 ? growth * last : now);
        const double p_ahead = ahead >= law.saturated() ? 0.0 : law.pressure_of(ahead);
        return std::min(now, stable(law.slope(p_ahead)));
      };
      plan.add_stability_limit(
          "drag and pressure wave [" + soil.name + "]",
          "(r + sqrt(r^2 + 4 w^2))/w^2, r = nS mu/(k k_rel rho_l), w^2 = 4 nS/(h^2 C rho_l), C = nS/K_l + n dS/dp",
          [&points = plan.fields.points, r, of_cell] {
            double least = std::numeric_limits<double>::infinity();
            for (const Block& block : points.blocks(static_cast<int>(r))) least = std::min(least, of_cell(block));
            return least;
          });
    });
  }
  if (moving_ != nullptr) add_wave_limit(plan);
  plan.add_accuracy_limit("growth", "1.5 x the step before", [this] {
    const double last = (*steps_)[0][0];
    return last > 0 ? growth * last : std::numeric_limits<double>::infinity();
  });
  plan.add(Phase::carry, "step length", [this, &plan] { (*steps_)[0][0] = plan.clock.dt; });
}

/// The undrained wave: skeleton and liquid moving together, stiffened by the liquid; C as above, saturated near p = 0.
template <int dim>
void TwoVelocityLiquid<dim>::add_wave_limit(StagePlan<dim>& plan) {
  TwoVelocityWater<dim>& w = *water_;
  const double bulk_modulus = plan.problem.water->bulk_modulus;
  for (std::size_t r = 0; r < plan.problem.soils.size(); ++r) {
    const Soil& soil = plan.problem.soils[r];
    with_soil_water(soil, *plan.problem.water, [&](const auto& laws) {
      const WaterContent law(laws.curve, bulk_modulus);
      const double modulus = LinearElastic(*soil.elastic).constrained_modulus();
      const auto of_cell = [&w, laws, law, modulus, solid = soil.grain_density, bulk_modulus](const Block& block) {
        const std::size_t c = block.cell;
        const double p = w.cells.pressure[c], pores = w.cells.pores[c] / w.cells.volume[c];
        const double saturation = laws.saturation(p);
        // Within a thousandth of the curve's scale of p = 0 a strain of 1e-6 saturates the cell.
        const double slope = p > -1e-3 * laws.curve.pressure_scale() ? law.saturated() / bulk_modulus : law.slope(p);
        const double density = (1 - pores) * solid + w.density * w.cells.water[c] / w.cells.volume[c];
        return w.cells.size[c] / std::sqrt(dim * (modulus + saturation * saturation / (pores * slope)) / density);
      };
      plan.add_stability_limit("undrained wave [" + soil.name + "]",
                               "h/(sqrt(dim) c), c^2 = (E_oed + S^2/C)/((1-n) rho_s + nS rho_l)",
                               [&points = plan.fields.points, r, of_cell] {
                                 double least = std::numeric_limits<double>::infinity();
                                 for (const Block& block : points.blocks(static_cast<int>(r)))
                                   least = std::min(least, of_cell(block));
                                 return least;
                               });
    });
  }
}

template void TwoVelocityLiquid<2>::add_state(StagePlan<2>&);
template void TwoVelocityLiquid<3>::add_state(StagePlan<3>&);
template void TwoVelocityLiquid<2>::add_limits(StagePlan<2>&);
template void TwoVelocityLiquid<3>::add_limits(StagePlan<3>&);
template void TwoVelocityLiquid<2>::add_wave_limit(StagePlan<2>&);
template void TwoVelocityLiquid<3>::add_wave_limit(StagePlan<3>&);

}  // namespace wetfront::mpm
