#include "mpm/laws/soil_water.h"
#include "mpm/two_velocity/two_velocity.h"

#include <algorithm>

/// Step VII of the two-velocity scheme pressures and conductivities of the nodes.
namespace wetfront::mpm {

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
  // At the end of the step, once points lie in their new cells, so that the limit of the next step knows it.
  plan.add(w.conductivities_in, "water of points to nodes", content_);
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
          w.cells.mobility[block.cell] = cell;
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

template void TwoVelocityLiquid<2>::add_state(StagePlan<2>&);
template void TwoVelocityLiquid<3>::add_state(StagePlan<3>&);

}  // namespace wetfront::mpm
