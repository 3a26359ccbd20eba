#include "verification/translate/to_mpm.h"

#include "verification/scene/read.h"
#include "verification/translate/initial_pressure.h"
#include "verification/translate/lay_soils.h"
#include "verification/translate/mpm_lacks.h"

#include <algorithm>
#include <stdexcept>

namespace wetfront::verification {
namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

mpm::RetentionSpec retention_of(const Retention& retention) {
  return std::visit(Overloaded{[](const VanGenuchten& law) -> mpm::RetentionSpec {
                                 return mpm::VanGenuchtenRetention{law.air_entry, law.lambda, law.s_min, law.s_max};
                               },
                               [](const Exponential& law) -> mpm::RetentionSpec {
                                 return mpm::ExponentialRetention{law.suction_scale, law.s_min, law.s_max};
                               },
                               [](const auto&) -> mpm::RetentionSpec {
                                 throw std::logic_error("a retention that mpm_lacks() has let through");
                               }},
                    retention);
}

mpm::PermeabilitySpec permeability_of(const Soil& soil) {
  switch (soil.permeability) {
    case PermeabilityLaw::mualem:
      return mpm::MualemPermeability{};
    case PermeabilityLaw::printed_mualem:
      return mpm::PrintedMualemPermeability{};
    case PermeabilityLaw::mualem_of_saturation:
      return mpm::MualemOfSaturationPermeability{};
    case PermeabilityLaw::exponential:
      return mpm::ExponentialPermeability{soil.permeability_suction_scale};
    case PermeabilityLaw::constant:
      return mpm::ConstantPermeability{};
    default:
      throw std::logic_error("a permeability that mpm_lacks() has let through");
  }
}

mpm::Soil soil_of(const Soil& soil) {
  mpm::Soil out{soil.name, soil.porosity,     soil.grain_density, soil.intrinsic_permeability, {}, {},
                {},        soil.origin.text()};
  if (soil.retention) {
    out.retention = retention_of(*soil.retention);
    out.permeability = permeability_of(soil);
  }
  if (soil.elastic) out.elastic = mpm::Elastic{soil.elastic->young, soil.elastic->poisson, soil.elastic->origin.text()};
  return out;
}

void add_boundaries(const Scene& scene, mpm::Problem<2>& problem) {
  for (const Rain& rain : scene.rains)
    problem.water_boundary.push_back(mpm::RainSide{rain.side, rain.record, rain.origin.text()});
  for (const Boundary& boundary : scene.boundaries) {
    const std::string origin = boundary.origin.text();
    if (boundary.water == WaterCondition::free_drainage)
      problem.water_boundary.push_back(mpm::FreeDrainageSide{boundary.side, origin});
    if (boundary.water == WaterCondition::pressure)
      problem.water_boundary.push_back(mpm::PressureSide{boundary.side, boundary.pressure, origin});
    if (boundary.water == WaterCondition::seepage_face)
      problem.water_boundary.push_back(mpm::RainSide{boundary.side, {{0}, {0}}, origin});
    if (boundary.fixed) problem.fixities.push_back({boundary.side, *boundary.fixed, origin});
  }
}

mpm::Stage stage_of(const Stage& stage, double end_time) {
  mpm::Stage out;
  out.name = stage.name;
  if (stage.scheme)
    out.liquid = *stage.scheme == Scheme::seepage ? mpm::LiquidScheme::seepage : mpm::LiquidScheme::implicit_drag;
  out.end_time = end_time;
  out.integrator = stage.backward_euler ? mpm::TimeIntegrator::backward_euler : mpm::TimeIntegrator::bdf2;
  out.time_tolerance = stage.time_tolerance;
  out.largest_step = stage.largest_step;
  out.step_safety = stage.step_safety;
  out.local_damping = stage.local_damping;
  out.mass_balance = stage.printed_mass_balance ? mpm::MassBalance::printed_2021 : mpm::MassBalance::conservative;
  out.origin = stage.origin.text();
  return out;
}

}  // namespace

mpm::Problem<2> to_mpm(const Scene& scene, const meshes::Mesh& mesh, const Timeline& timeline) {
  if (const auto lacking = mpm_lacks(scene); !lacking.empty()) throw SceneError(lacking);
  mpm::Problem<2> problem;
  problem.mesh = mesh;
  problem.gravity = {scene.gravity[0], scene.gravity[1]};
  problem.gravity_origin = scene.gravity_origin.text();
  for (const Soil* soil : soils_by_region(scene, mesh)) problem.soils.push_back(soil_of(*soil));
  if (scene.water) {
    const Water& water = *scene.water;
    problem.water = mpm::Water{water.density, water.bulk_modulus, water.viscosity, water.origin.text()};
    problem.initial_pressure = initial_pressure(scene, mesh);
  }
  add_boundaries(scene, problem);
  for (const Probe& probe : scene.probes) problem.probes.push_back({probe.name, probe.position, probe.origin.text()});
  problem.points_per_cell = scene.mpm.points_per_cell;
  for (std::size_t i = 0; i < scene.stages.size(); ++i)
    problem.stages.push_back(stage_of(scene.stages[i], timeline.stage_end[i]));
  problem.output_times = timeline.comparison_times;
  return problem;
}

}  // namespace wetfront::verification
