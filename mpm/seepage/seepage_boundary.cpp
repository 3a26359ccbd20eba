#include "mpm/seepage/seepage_boundary.h"

#include "mpm/boundary/boundary_side.h"
#include "mpm/laws/soil_water.h"
#include "mpm/record/water_ledger.h"

#include <algorithm>

namespace wetfront::mpm {

namespace {

/// Conductance of the surface film per K_s/h of the soil behind. physics.md section 3: insensitive over six decades; a
/// thousand keeps a ponded surface within I h mu/(1e3 k) < 0.1 Pa of zero.
constexpr double film_conductance = 1e3;

template <int dim>
struct RainedNode {
  int node;
  double area;  ///< horizontal; of a seepage face the whole [m^(dim-1)]
  double film;  ///< beta [m/(s Pa)]
};

template <int dim>
std::vector<RainedNode<dim>> rained_nodes(const StagePlan<dim>& plan, const RainSide& rain) {
  const auto side = boundary_side(plan, rain.side, "rainfall", rain.origin);
  const auto areas = open_areas(side, plan.problem, rain);
  const auto& grid = plan.fields.grid;
  std::vector<double> altitude(grid.node_count(), 0.0);
  for (const Block& block : plan.fields.points.blocks())
    for (int i = 0; i < cell_nodes<dim>; ++i) {
      double& h = altitude[static_cast<std::size_t>(block.nodes[i])];
      h = std::max(h, grid.smallest_altitude(block.cell));
    }
  std::vector<RainedNode<dim>> nodes;
  for (std::size_t k = 0; k < side.nodes.size(); ++k) {
    const auto& node = side.nodes[k];
    const Soil& soil = plan.problem.soils[static_cast<std::size_t>(node.region)];
    const double mobility = soil.intrinsic_permeability / plan.problem.water->viscosity;
    nodes.push_back(
        {node.index, areas[k], film_conductance * mobility / altitude[static_cast<std::size_t>(node.index)]});
  }
  return nodes;
}

}  // namespace

template <int dim>
void RainOnSeepage<dim>::join(StagePlan<dim>& plan) {
  Column& imposed = water_->cumulate(plan, "rain imposed", "Q_in");
  Column& run_off = water_->cumulate(plan, "rain run-off", "Q_run");
  Column& asked = plan.provide_on_nodes({"rain asked", "Q_rain", dim == 2 ? "m2" : "m3"});
  Column& ledger = plan.require_on_run("water ledger");
  plan.require_on_nodes("pressure");
  std::vector<std::pair<RainSide, std::vector<RainedNode<dim>>>> sides;
  for (const auto& boundary : plan.problem.water_boundary)
    if (const auto* rain = std::get_if<RainSide>(&boundary)) {
      sides.emplace_back(*rain, rained_nodes(plan, *rain));
      for (double start : rain->rain.start) plan.add_break(start);
    }
  const auto take = [this, &plan, sides, &imposed, &run_off] {
    for (const auto& [rain, nodes] : sides) {
      const double intensity = meshes::intensity_after(rain.rain, plan.clock.time);
      for (const auto& [node, area, film] : nodes) {
        const double capacity = -film * (*water_->trial)[0][node];
        const double taken = std::min(intensity, capacity);
        (*water_->inflow)[0][node] += area * taken;
        if (capacity < intensity) water_->add_slope(node, -area * film);
        imposed[0][node] += area * std::max(taken, 0.0);
        run_off[0][node] += area * (intensity - std::max(taken, 0.0));
        (*water_->outflow)[0][node] += area * std::max(-taken, 0.0);
      }
    }
  };
  water_->terms.push_back(&plan.add_iterated(Phase::pressure, "rainfall", take));
  plan.add(Phase::carry, "rain ledger", [&plan, sides, &asked, &ledger] {
    asked.fill(0);
    for (const auto& [rain, nodes] : sides)
      for (const auto& node : nodes) asked[0][node.node] += node.area * meshes::depth_until(rain.rain, plan.clock.end);
    const auto sum = [&plan](const char* name) {
      double total = 0;
      for (double value : plan.fields.grid.columns.at(name).values()) total += value;
      return total;
    };
    ledger[ledger_rain_asked][0] = sum("rain asked");
    ledger[ledger_infiltrated][0] = sum("rain imposed");
    ledger[ledger_run_off][0] = sum("rain run-off");
  });
  plan.at_finish([&plan, sides](meshes::FieldHistory& history) {
    auto& columns = plan.fields.grid.columns;
    history.rain_by_node.clear();
    for (const auto& [rain, nodes] : sides)
      for (const auto& node : nodes) {
        const auto i = static_cast<std::size_t>(node.node);
        history.rain_by_node.push_back({node.node, plan.problem.mesh.nodes[i], columns.at("rain asked")[0][i],
                                        columns.at("rain imposed")[0][i], columns.at("rain run-off")[0][i]});
      }
  });
}

template <int dim>
void HeldPressure<dim>::join(StagePlan<dim>& plan) {
  plan.require_on_nodes("outflow");
  for (const auto& boundary : plan.problem.water_boundary)
    if (const auto* held = std::get_if<PressureSide>(&boundary))
      for (const auto& node : boundary_side(plan, held->side, "a prescribed pressure", held->origin).nodes)
        water_->held.push_back({node.index, held->pressure});
}

template <int dim>
void FreeDrainage<dim>::join(StagePlan<dim>& plan) {
  plan.require_on_run("gravity");
  const Water& liquid = *plan.problem.water;
  for (const auto& boundary : plan.problem.water_boundary) {
    const auto* drainage = std::get_if<FreeDrainageSide>(&boundary);
    if (drainage == nullptr) continue;
    const auto side = boundary_side(plan, drainage->side, "free drainage", drainage->origin);
    for (std::size_t r = 0; r < plan.problem.soils.size(); ++r) {
      std::vector<std::pair<int, double>> drains;  // node, integral of rho g.n
      for (const auto& node : side.nodes) {
        double weight = 0;
        for (int a = 0; a < dim; ++a) weight += node.area[a] * liquid.density * plan.problem.gravity[a];
        if (static_cast<std::size_t>(node.region) == r && weight > 0) drains.emplace_back(node.index, weight);
      }
      if (drains.empty()) continue;
      with_soil_water(plan.problem.soils[r], liquid, [&](const auto& laws) {
        const auto drain = [this, laws, drains] {
          for (const auto& [node, weight] : drains) {
            const ValueAndSlope relative = laws.permeability(laws.curve, -(*water_->trial)[0][node]);
            const double scale = weight * laws.saturated_mobility;
            (*water_->inflow)[0][node] -= scale * relative.value;
            (*water_->outflow)[0][node] += scale * relative.value;
            water_->add_slope(node, scale * relative.slope);
          }
        };
        water_->terms.push_back(&plan.add_iterated(Phase::pressure, "free drainage [" + drainage->side + "]", drain));
      });
    }
  }
}

template class RainOnSeepage<2>;
template class RainOnSeepage<3>;
template class HeldPressure<2>;
template class HeldPressure<3>;
template class FreeDrainage<2>;
template class FreeDrainage<3>;

}  // namespace wetfront::mpm
