#include "verification/translate/to_reference.h"

#include "verification/translate/antecedent.h"
#include "verification/translate/initial_pressure.h"
#include "verification/translate/lay_soils.h"
#include "verification/translate/reference_sides.h"
#include "verification/translate/reference_soil.h"
#include "verification/translate/scene_mesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace wetfront::verification {
namespace {

fem_reference::Integrator integrator_of(const ReferenceSettings& settings) {
  if (settings.integrator == ReferenceSettings::Integrator::dirk) return fem_reference::Integrator::dirk;
  return settings.integrator == ReferenceSettings::Integrator::bdf ? fem_reference::Integrator::bdf
                                                                   : fem_reference::Integrator::backward_euler;
}

}  // namespace

fem_reference::RichardsProblem to_reference(const Scene& scene, const Timeline& timeline, Resolution resolution) {
  fem_reference::RichardsProblem problem;
  problem.mesh = reference_mesh(scene, resolution.cells, resolution.halvings);
  const bool line = problem.mesh.dim == 1;
  const double g = gravity_magnitude(scene);
  for (int axis = 0; axis < 3; ++axis) problem.gravity_direction[axis] = scene.gravity[axis] / g;
  if (line) problem.gravity_direction = {-1, 0, 0};
  problem.unit_weight = scene.water->density * g;
  for (const Soil* soil : soils_by_region(scene, problem.mesh))
    problem.soils.push_back(reference_soil(scene, *soil, problem.mesh.dim));
  problem.conductivity_factor = conductivity_factors(scene, problem.mesh);
  problem.boundary = reference_sides(scene, problem.unit_weight);
  problem.end_time = timeline.end();
  problem.output_times = timeline.comparison_times;
  if (problem.output_times.empty()) problem.output_times = {problem.end_time};
  for (const Probe& probe : scene.probes)
    problem.gauges.push_back({probe.name, line ? meshes::Point{probe.position[1]} : probe.position});
  const ReferenceSettings& settings = *scene.reference;
  problem.integrator = integrator_of(settings);
  problem.degree = settings.degree;
  if (settings
          .adaptive)  // what a cell may differ by shrinks with the cell, or finer meshes would not be finer at a front
    problem.adaptivity = fem_reference::Adaptivity{settings.adaptive->levels,
                                                   settings.adaptive->threshold * std::exp2(-resolution.halvings)};
  problem.tolerance = resolution.tolerance;
  if (start_is_computed(scene))
    problem.initial_head = antecedent_head(scene, problem);
  else
    for (double pressure : initial_pressure(scene, problem.mesh))
      problem.initial_head.push_back(pressure / problem.unit_weight);
  return problem;
}

}  // namespace wetfront::verification
