#include "verification/translate/to_mpm.h"

#include "verification/scene/read.h"
#include "verification/translate/initial_pressure.h"
#include "verification/translate/lay_soils.h"
#include "verification/translate/mpm_lacks.h"
#include "verification/translate/mpm_sides.h"
#include "verification/translate/mpm_skeleton.h"
#include "verification/translate/mpm_soil.h"
#include "verification/translate/scene_mesh.h"

namespace wetfront::verification {
namespace {

mpm::LiquidScheme scheme_of(Scheme scheme) {
  switch (scheme) {
    case Scheme::seepage:
      return mpm::LiquidScheme::seepage;
    case Scheme::semi_implicit:
      return mpm::LiquidScheme::semi_implicit;
    case Scheme::implicit_drag:
      return mpm::LiquidScheme::implicit_drag;
    case Scheme::explicit_drag:
      break;
  }
  return mpm::LiquidScheme::explicit_drag;
}

mpm::RainScheme rain_scheme_of(RainEntry entry) {
  switch (entry) {
    case RainEntry::standard:
      return mpm::RainScheme::standard;
    case RainEntry::martinelli_2020:
      return mpm::RainScheme::martinelli_2020;
    case RainEntry::bandara_2016:
      return mpm::RainScheme::bandara_2016;
    case RainEntry::consistent_flux:
      break;
  }
  return mpm::RainScheme::consistent_flux;
}

mpm::Stage stage_of(const Stage& stage, double end_time) {
  mpm::Stage out;
  out.name = stage.name;
  if (stage.scheme) out.liquid = scheme_of(*stage.scheme);
  out.end_time = end_time;
  out.integrator = stage.backward_euler ? mpm::TimeIntegrator::backward_euler : mpm::TimeIntegrator::bdf2;
  out.time_tolerance = stage.time_tolerance;
  out.largest_step = stage.largest_step;
  out.step_safety = stage.step_safety;
  out.local_damping = stage.local_damping;
  out.motion = stage.motion.quasi_static ? mpm::SkeletonMotion::quasi_static : mpm::SkeletonMotion::dynamic;
  out.relaxation.unbalanced_ratio = stage.motion.unbalanced_ratio;
  out.relaxation.damping = stage.motion.relaxation_damping;
  out.relaxation.coupling_tolerance = stage.motion.coupling_tolerance;
  const StageEvent& event = stage.event;
  if (event.kind == StageEvent::Kind::failure) {
    out.ends_with = mpm::StageEnd::failure;
    out.failure = {event.displacement, event.unbalanced_ratio, event.shortest_step};
  }
  if (event.kind == StageEvent::Kind::rest) {
    out.ends_with = mpm::StageEnd::rest;
    out.rest.energy_ratio = event.energy_ratio;
    out.rest.hold = event.hold;
  }
  out.longest = stage.lasts.value_or(0);
  out.picture_every = stage.picture_every;
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
  for (const Soil* soil : soils_by_region(scene, mesh)) problem.soils.push_back(mpm_soil(scene, *soil));
  if (scene.water) {
    const Water& water = *scene.water;
    problem.water =
        mpm::Water{water.density, scene.mpm.water_softening * water.bulk_modulus, water.viscosity, water.origin.text()};
    problem.initial_pressure = initial_pressure(scene, mesh);
    problem.conductivity_factor = conductivity_factors(scene, mesh);
  }
  problem.surface = surface_inside_cells(scene);
  problem.water_boundary = mpm_sides(scene);
  add_skeleton_sides(scene, problem);
  problem.skeleton = skeleton_scheme_of(scene.skeleton);
  if (scene.skeleton.k0_stress) problem.initial_stress = mpm::InitialStress::k0;
  problem.threads = scene.mpm.threads;
  for (const Probe& probe : scene.probes) problem.probes.push_back({probe.name, probe.position, probe.origin.text()});
  for (const Probe& rider : scene.riders) problem.riders.push_back({rider.name, rider.position, rider.origin.text()});
  problem.points_per_cell = scene.mpm.points_per_cell;
  problem.rain_scheme = rain_scheme_of(scene.mpm.rain_entry);
  problem.cpu_budget = scene.mpm.cpu_budget;
  for (std::size_t i = 0; i < scene.stages.size(); ++i)
    problem.stages.push_back(stage_of(scene.stages[i], timeline.stage_end[i]));
  problem.output_times = timeline.comparison_times;
  return problem;
}

}  // namespace wetfront::verification
