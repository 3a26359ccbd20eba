#include "mpm/skeleton/initial_stress.h"

#include "mpm/laws/tensor.h"
#include "mpm/skeleton/overburden.h"

namespace wetfront::mpm {

namespace {

void check_law(const Soil& soil) {
  if (soil.law && (std::holds_alternative<NeoHookean>(*soil.law) || std::holds_alternative<Hencky>(*soil.law)))
    throw CannotPlan(soil.origin + ": soil '" + soil.name +
                     "' is to begin with a stress at rest, but its law takes stress from the deformation alone (which "
                     "is none at the start). Use another law, or let the soil settle under its weight");
}

double at_rest(const Soil& soil) {
  return soil.earth_pressure_at_rest.value_or(soil.elastic->poisson / (1 - soil.elastic->poisson));
}

}  // namespace

template <int dim>
void InitialStressEffect<dim>::join(StagePlan<dim>& plan) {
  for (const Soil& soil : plan.problem.soils) check_law(soil);
  if (plan.index() != 0) return;
  Column& stress = plan.require_on_points("stress");
  plan.at_entry([&plan, &stress] {
    const Overburden<dim> overburden(plan);
    const Vector<dim>& up = overburden.up();
    const auto& points = plan.fields.points;
    for (const Block& block : points.blocks()) {
      const double k0 = at_rest(plan.problem.soils[static_cast<std::size_t>(plan.fields.grid.region(block.cell))]);
      for (std::size_t p = block.first; p < block.first + block.count; ++p) {
        const Vector<dim> x = points.position(p);
        const double vertical = overburden.pore_stress(block.cell, x) - overburden.above(x);
        const auto entry = [&](int a, int b) { return vertical * ((1 - k0) * up[a] * up[b] + (a == b ? k0 : 0.0)); };
        for (int a = 0; a < dim; ++a) stress[a][p] = entry(a, a);
        stress[3][p] = entry(0, 1);
        if constexpr (dim == 2) {
          stress[2][p] = k0 * vertical;
        } else {
          stress[4][p] = entry(1, 2);
          stress[5][p] = entry(2, 0);
        }
      }
    }
  });
}

template class InitialStressEffect<2>;
template class InitialStressEffect<3>;

}  // namespace wetfront::mpm
