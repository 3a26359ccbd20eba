#include "verification/translate/antecedent.h"

#include "verification/translate/initial_pressure.h"
#include "verification/translate/reference_sides.h"
#include "verification/translate/timeline.h"
#include "verification/translate/to_reference.h"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

namespace wetfront::verification {
namespace {

namespace fem = fem_reference;

std::vector<double> heads(std::vector<double> pressure, double unit_weight) {
  for (double& value : pressure) value /= unit_weight;
  return pressure;
}

/// At rest over a water table at the lowest point of the ground: where the search for a steady state starts.
HydrostaticStart over_lowest(const Scene& scene, const meshes::Mesh& mesh) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const meshes::Point& node : mesh.nodes) lowest = std::min(lowest, elevation(scene, node, mesh.dim));
  return {lowest, std::numeric_limits<double>::infinity()};
}

std::vector<double> steady(const Scene& scene, const SteadyStart& start, fem::RichardsProblem& problem) {
  problem.boundary = antecedent_sides(scene, problem.unit_weight, {{0}, {start.rain}}, false);
  problem.initial_head =
      heads(hydrostatic_pressure(scene, over_lowest(scene, problem.mesh), problem.mesh), problem.unit_weight);
  try {
    return fem::steady_head(problem);
  } catch (const fem::GaveUp& error) {
    throw std::runtime_error(scene.initial->origin.text() +
                             ": the antecedent rain has no steady state that was found (" + error.what() +
                             "). Let water out below, e.g. with water = \"seepage-face\" or a "
                             "pressure, or use spin_up");
  }
}

std::vector<double> spun_up(const Scene& scene, const SpinUpStart& start, fem::RichardsProblem& problem) {
  problem.boundary = antecedent_sides(scene, problem.unit_weight, start.rain, true);
  problem.initial_head = heads(hydrostatic_pressure(scene, start.from, problem.mesh), problem.unit_weight);
  problem.end_time = start.duration;
  problem.output_times = {start.duration};
  problem.gauges.clear();
  try {
    const meshes::FieldHistory history = fem::solve(problem);
    return heads(history.snapshots.back().node_pressure, problem.unit_weight);
  } catch (const fem::GaveUp& error) {
    throw std::runtime_error(scene.initial->origin.text() + ": the spin-up gave up (" + error.what() +
                             "). Start it from a wetter state, or loosen [reference] tolerance");
  }
}

}  // namespace

std::vector<double> antecedent_head(const Scene& scene, fem::RichardsProblem problem) {
  problem.adaptivity.reset();  // the start is wanted at the nodes of this mesh
  if (const auto* start = std::get_if<SteadyStart>(&scene.initial->pressure)) return steady(scene, *start, problem);
  return spun_up(scene, std::get<SpinUpStart>(scene.initial->pressure), problem);
}

const FormerField& antecedent_pressure(const Scene& scene) {
  static std::map<std::string, FormerField> known;
  const std::string key = scene.path.string() + '\n' + scene.text;
  const auto found = known.find(key);
  if (found != known.end()) return found->second;
  const ReferenceSettings& settings = *scene.reference;
  const fem::RichardsProblem problem = to_reference(scene, timeline(scene), {settings.cells, 0, settings.tolerance});
  FormerField field{problem.mesh, problem.initial_head};
  for (double& value : field.pressure) value *= problem.unit_weight;
  return known.emplace(key, std::move(field)).first->second;
}

}  // namespace wetfront::verification
