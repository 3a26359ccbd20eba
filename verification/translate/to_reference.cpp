#include "verification/translate/to_reference.h"

#include "verification/translate/initial_pressure.h"
#include "verification/translate/scene_mesh.h"

#include <algorithm>
#include <stdexcept>

namespace wetfront::verification {
namespace {

/// Heads for pressures, conductivity for permeability: the numbers change, the soil does not.
class HydraulicUnits {
 public:
  explicit HydraulicUnits(const Scene& scene)
      : unit_weight(scene.water->density * gravity_magnitude(scene)),
        viscosity_(scene.water->viscosity),
        bulk_modulus_(scene.water->bulk_modulus) {}

  fem_reference::Soil soil(const Soil& soil) const {
    fem_reference::Soil out;
    out.name = soil.name;
    out.porosity = soil.porosity;
    out.retention = retention(soil);
    out.conductivity = conductivity(soil);
    out.saturated_conductivity = soil.intrinsic_permeability * unit_weight / viscosity_;
    out.specific_storage = soil.porosity * unit_weight / bulk_modulus_;
    return out;
  }

  const double unit_weight;  ///< Pa/m

 private:
  fem_reference::Retention retention(const Soil& soil) const {
    const double n = soil.porosity;
    if (const auto* law = std::get_if<VanGenuchten>(&*soil.retention))
      return fem_reference::VanGenuchten{n * law->s_min, n * law->s_max, unit_weight / law->air_entry,
                                         1 / (1 - law->lambda)};
    const auto& law = std::get<Exponential>(*soil.retention);
    return fem_reference::ExponentialRetention{n * law.s_min, n * law.s_max, unit_weight / law.suction_scale};
  }

  /// The reference always computes what is right: research variants of the candidate (printed formulas, S in place
  /// of the effective saturation) are compared with the corrected law.
  fem_reference::Conductivity conductivity(const Soil& soil) const {
    if (soil.permeability == PermeabilityLaw::constant) return fem_reference::ConstantConductivity{};
    if (soil.permeability == PermeabilityLaw::exponential)
      return fem_reference::ExponentialConductivity{unit_weight / soil.permeability_suction_scale};
    return fem_reference::MualemConductivity{};
  }

  double viscosity_, bulk_modulus_;
};

void add_boundaries(const Scene& scene, double unit_weight, fem_reference::RichardsProblem& problem) {
  for (const Rain& rain : scene.rains) problem.boundary.push_back(fem_reference::RainSide{rain.side, rain.record});
  for (const Boundary& boundary : scene.boundaries) {
    if (boundary.water == WaterCondition::free_drainage)
      problem.boundary.push_back(fem_reference::FreeDrainageSide{boundary.side});
    if (boundary.water == WaterCondition::pressure)
      problem.boundary.push_back(fem_reference::HeadSide{boundary.side, boundary.pressure / unit_weight});
    if (boundary.water == WaterCondition::seepage_face)
      problem.boundary.push_back(fem_reference::RainSide{boundary.side, {{0}, {0}}});
  }
}

}  // namespace

fem_reference::RichardsProblem to_reference(const Scene& scene, const Timeline& timeline, Resolution resolution) {
  fem_reference::RichardsProblem problem;
  problem.mesh = reference_mesh(scene, resolution.cells, resolution.halvings);
  const bool line = problem.mesh.dim == 1;
  const double g = gravity_magnitude(scene);
  for (int axis = 0; axis < 3; ++axis) problem.gravity_direction[axis] = scene.gravity[axis] / g;
  if (line) problem.gravity_direction = {-1, 0, 0};
  const HydraulicUnits units(scene);
  problem.unit_weight = units.unit_weight;
  for (const std::string& region : problem.mesh.region_names) {
    const auto named =
        std::find_if(scene.soils.begin(), scene.soils.end(), [&](const Soil& soil) { return soil.name == region; });
    problem.soils.push_back(units.soil(named == scene.soils.end() ? scene.soils.front() : *named));
  }
  add_boundaries(scene, units.unit_weight, problem);
  for (double pressure : initial_pressure(scene, problem.mesh))
    problem.initial_head.push_back(pressure / units.unit_weight);
  problem.end_time = timeline.end();
  problem.output_times = timeline.comparison_times;
  for (const Probe& probe : scene.probes)
    problem.gauges.push_back({probe.name, line ? meshes::Point{probe.position[1]} : probe.position});
  if (scene.reference->backward_euler) problem.integrator = fem_reference::Integrator::backward_euler;
  problem.tolerance = resolution.tolerance;
  return problem;
}

}  // namespace wetfront::verification
