#include "mpm/seepage/seepage.h"

#include "mpm/seepage/darcy_flux.h"
#include "mpm/seepage/liquid_inertia.h"
#include "mpm/seepage/pore_storage.h"

namespace wetfront::mpm {

namespace {

/// Calls `body(driving, tensor)` with what the scene has: gravity or none, a permeability tensor or a number.
template <int dim, class Body>
void with_conduction(const StagePlan<dim>& plan, const Soil& soil, Body&& body) {
  const auto with_tensor = [&](const auto& driving) {
    if (is_isotropic(soil))
      body(driving, Isotropic<dim>{});
    else
      body(driving, Anisotropic<dim>(soil.anisotropy));
  };
  const Column* gravity = plan.fields.run.find("gravity");
  if (gravity == nullptr || gravity->provided_by().empty()) return with_tensor(PressureOnly<dim>{});
  PressureAndWeight<dim> driving{plan.problem.gravity};
  for (double& component : driving.weight) component *= plan.problem.water->density;
  with_tensor(driving);
}

}  // namespace

template <int dim>
void Seepage<dim>::add_storage(StagePlan<dim>& plan) {
  for (std::size_t r = 0; r < plan.problem.soils.size(); ++r) {
    const int region = static_cast<int>(r);
    const auto storage = [this, region, content = soils_[r].content] {
      if (skeleton_ != nullptr)
        skeleton_->add_storage(region, content);
      else
        store_in_pores(*water_, columns_, region, content);
    };
    const std::string name = "storage [" + plan.problem.soils[r].name + "]";
    water_->terms.push_back(&plan.add_iterated(Phase::pressure, name, storage));
  }
  if (skeleton_ != nullptr)
    water_->terms.push_back(
        &plan.add_iterated(Phase::pressure, "stabilisation and mixing", [this] { skeleton_->add_offsets(); }));
}

template <int dim>
void Seepage<dim>::add_flux(StagePlan<dim>& plan) {
  const Column &volume = plan.require_on_points("volume"), &value = plan.require_on_points("shape value"),
               &gradient = plan.require_on_points("shape gradient");
  for (std::size_t r = 0; r < plan.problem.soils.size(); ++r) {
    const int region = static_cast<int>(r);
    const Soil& soil = plan.problem.soils[r];
    with_conduction(plan, soil, [&](const auto& driving, const auto& tensor) {
      const auto add = [&](const auto& inertia) {
        const DarcyFlux flux{*water_, slots_, mobility_[r], reach_, volume, value, gradient, soils_[r].permeability,
                             driving, tensor, inertia};
        const auto body = [&points = plan.fields.points, region, flux] {
          for (const Block& block : points.blocks(region)) flux(block);
        };
        water_->terms.push_back(&plan.add_iterated(Phase::pressure, "Darcy flux [" + soil.name + "]", body));
        return flux;
      };
      if (columns_.flux == nullptr) {
        add(NoInertia<dim>{});
        return;
      }
      const auto add_with_memory = [&](const auto& inertia) {
        const auto remember = [&points = plan.fields.points, region, flux = add(inertia), memory = columns_.flux] {
          for (const Block& block : points.blocks(region)) flux.remember(block, *memory);
        };
        water_->accepted.push_back(&plan.add_iterated(Phase::pressure, "flux of points [" + soil.name + "]", remember));
      };
      const double density = plan.problem.water->density;
      if (columns_.acceleration == nullptr)
        add_with_memory(LiquidInertia<dim>{columns_.flux, columns_.point_saturation, soil.porosity / density});
      else
        add_with_memory(LiquidInertiaInMotion<dim>{
            {columns_.flux, columns_.yielding, 1 / density}, columns_.acceleration, density});
    });
  }
}

template void Seepage<2>::add_storage(StagePlan<2>&);
template void Seepage<3>::add_storage(StagePlan<3>&);
template void Seepage<2>::add_flux(StagePlan<2>&);
template void Seepage<3>::add_flux(StagePlan<3>&);

}  // namespace wetfront::mpm
