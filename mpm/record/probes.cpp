#include "mpm/record/probes.h"

#include "mpm/laws/soil_water.h"

#include <algorithm>

namespace wetfront::mpm {

namespace {

template <int dim>
struct Place {
  const int* nodes;
  Stencil<dim> stencil;
  std::function<double(double)> saturation;
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
  Place<dim> place{grid.cell_nodes_of(cell), {}, {}};
  grid.stencil(cell, grid.local(cell, x), place.stencil);
  place.saturation =
      saturation_of(plan.problem.soils[static_cast<std::size_t>(grid.region(cell))], *plan.problem.water);
  return place;
}

}  // namespace

template <int dim>
void Probes<dim>::join(StagePlan<dim>& plan) {
  const Column& pressure = plan.require_on_nodes("pressure");
  std::vector<Place<dim>> places;
  for (const Probe& probe : plan.problem.probes) places.push_back(place_of(plan, probe));
  plan.at_record([&plan, &pressure, places](double time, meshes::FieldHistory& history) {
    if (history.gauges.empty())
      for (const Probe& probe : plan.problem.probes) history.gauges.push_back({probe.name, probe.position, {}, {}, {}});
    for (std::size_t k = 0; k < places.size(); ++k) {
      double p = 0;
      for (int i = 0; i < cell_nodes<dim>; ++i) p += places[k].stencil.value[i] * pressure[0][places[k].nodes[i]];
      history.gauges[k].time.push_back(time);
      history.gauges[k].pressure.push_back(p);
      history.gauges[k].saturation.push_back(places[k].saturation(p));
    }
  });
}

template class Probes<2>;
template class Probes<3>;

}  // namespace wetfront::mpm
