#include "mpm/record/probes.h"

#include "mpm/grid/soils_of_cells.h"
#include "mpm/laws/soil_water.h"

#include <algorithm>

namespace wetfront::mpm {

namespace {

template <int dim>
struct Place {
  Vector<dim> x{};
  std::size_t cell = 0;
  Stencil<dim> stencil{};
};

template <int dim>
Place<dim> place_of(const StagePlan<dim>& plan, const Probe& probe) {
  const auto& grid = plan.fields.grid;
  Vector<dim> x{};
  std::copy_n(probe.position.begin(), dim, x.begin());
  const int found = grid.find_cell(x, -1);
  if (found < 0 || !plan.fields.points.occupied(static_cast<std::size_t>(found)))
    throw CannotPlan(probe.origin + ": probe '" + probe.name +
                     "' lies outside the soil (no cell with material points holds it). Move it inside");
  const auto cell = static_cast<std::size_t>(found);
  Place<dim> place{x, cell, {}};
  grid.stencil(cell, grid.local(cell, x), place.stencil);
  return place;
}

}  // namespace

template <int dim>
void Probes<dim>::join(StagePlan<dim>& plan) {
  const Column& pressure = plan.require_on_nodes("pressure");
  std::vector<Place<dim>> places;
  for (const Probe& probe : plan.problem.probes) places.push_back(place_of(plan, probe));
  std::vector<std::function<double(double)>> saturation;
  for (const Soil& soil : plan.problem.soils) saturation.push_back(saturation_of(soil, *plan.problem.water));
  plan.at_record([&plan, &pressure, places, saturation](double time, meshes::FieldHistory& history) {
    if (history.gauges.empty())
      for (const Probe& probe : plan.problem.probes) history.gauges.push_back({probe.name, probe.position, {}, {}, {}});
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Place<dim>& place = places[k];
      const int* nodes = plan.fields.grid.cell_nodes_of(place.cell);
      double p = 0;
      for (int i = 0; i < cell_nodes<dim>; ++i) p += place.stencil.value[i] * pressure[0][nodes[i]];
      // The soil that is at the gauge now; where all has gone, what was put there.
      const int here = soil_at<dim>(plan.fields.points, place.cell, place.x);
      const auto soil = static_cast<std::size_t>(here >= 0 ? here : plan.fields.grid.region(place.cell));
      history.gauges[k].time.push_back(time);
      history.gauges[k].pressure.push_back(p);
      history.gauges[k].saturation.push_back(saturation[soil](p));
    }
  });
}

template class Probes<2>;
template class Probes<3>;

}  // namespace wetfront::mpm
