#include "verification/ledger/probes.h"

#include "fem_reference/soil/soil_law.h"
#include "meshes/evaluate.h"
#include "verification/compare/profile.h"
#include "verification/ledger/delivered_rain.h"
#include "verification/run/solve_richards.h"
#include "verification/translate/to_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

constexpr double probe_budget = 60;  ///< CPU seconds that one probe run may be expected to take

}  // namespace

Quantities operator-(const Quantities& a, const Quantities& b) {
  Quantities out;
  for (int q = 0; q < explained_quantities; ++q) out[q] = a[q] - b[q];
  return out;
}

CauseShares unprobed(const std::string& cause, const std::string& why) {
  CauseShares out;
  out.cause = cause;
  out.note = why;
  out.probed = false;
  return out;
}

Probes::Probes(const Explained& it, std::size_t index)
    : it_(it),
      index_(index),
      read_(it.scene, index, it.timeline.comparison_times[index]),
      problem_(to_reference(it.scene, it.timeline, {it.scene.reference->cells, 0, it.scene.reference->tolerance})) {
  const auto& reference = it.reference.reference.history;
  candidate = read_(it.candidate, it.candidate);
  truth = read_(reference, reference);
  on_cells = read_(reference, it.candidate);
  by_finer_cells = read_(it.reference.finer.history, it.candidate) - on_cells;
  by_tighter_steps = read_(it.reference.tighter.history, it.candidate) - on_cells;
  for (int q = 0; q < explained_quantities; ++q)
    bound[q] = mesh_safety * std::abs(by_finer_cells[q]) + step_safety * std::abs(by_tighter_steps[q]);
}

Share Probes::of_the_reference(const std::string& cause, const Quantities& change, double safety, int quantity) {
  return {cause, change[quantity], safety * std::abs(change[quantity]), true, true, ""};
}

std::vector<CauseShares> Probes::all() {
  std::vector<CauseShares> shares{boundary(), interpolation(),
                                  limit("mesh", "on cells half as large", &Rerun::finer_cells, 8),
                                  limit("time step", "with smaller steps", &Rerun::finer_steps, 4), physics()};
  for (CauseShares& law : laws()) shares.push_back(std::move(law));
  return shares;
}

std::optional<meshes::FieldHistory> Probes::reference_with(const std::string& what, const Change& change) {
  return finished(what, [&] {
    fem_reference::RichardsProblem problem = problem_;
    change(problem);
    return solve_richards(problem, what, it_.store);
  });
}

std::optional<meshes::FieldHistory> Probes::again(const std::string& what, const Rerun& rerun) {
  if (!it_.rerun) return {};
  return finished(what, [&] { return it_.rerun(rerun); });
}

std::optional<meshes::FieldHistory> Probes::finished(const std::string& what, const std::function<Solved()>& run) {
  try {
    Solved solved = run();
    cpu_seconds += solved.history.cpu_seconds;
    log.push_back(
        fmt::format("probe: {}, {:.2f} CPU-s{}", what, solved.history.cpu_seconds,
                    solved.taken_from.empty() ? "" : " when it was computed, taken from " + solved.taken_from));
    if (solved.gave_up.empty()) return std::move(solved.history);
    log.push_back("probe: " + what + " gave up: " + solved.gave_up);
  } catch (const std::exception& error) {  // CannotPlan, a scene or a problem that is refused
    log.push_back("probe: " + what + " cannot be run: " + error.what());
  }
  return {};
}

/// The reference under the rain that the candidate really took.
CauseShares Probes::boundary() {
  const std::string cause = "boundary flux";
  const auto& rains = it_.scene.rains;
  if (rains.empty()) return unprobed(cause, "it does not rain");
  if (rains.size() > 1) return unprobed(cause, "it rains on several sides, and what each took is not told apart");
  const meshes::RainRecord rain = delivered_rain(it_.candidate.ledger, rain_area(it_.scene, it_.candidate.mesh));
  const auto history = reference_with("the reference with the flux that was delivered", [&](auto& problem) {
    for (auto& side : problem.boundary) {
      if (auto* sky = std::get_if<fem_reference::RainSide>(&side)) sky->rain = rain, sky->evaporation = {};
      if (auto* lake = std::get_if<fem_reference::WaterLevelSide>(&side)) lake->rain = rain;
    }
  });
  if (!history) return unprobed(cause, "the reference gave up or was refused under that flux (see the log)");
  CauseShares out;
  out.cause = cause;
  const Quantities with = read_(*history, it_.candidate);
  out.value = with - on_cells;
  for (int q = 0; q < explained_quantities; ++q) out.uncertainty[q] = 1e-4 * std::abs(with[q]);  // of delivered_rain
  out.note = "the reference run again with the flux that the candidate's stored water says went in";
  return out;
}

/// The reference read where the candidate has its values: fronts in its cells; water through its shape functions at its
/// nodes or, where a scheme carries averages over cells, at its points.
CauseShares Probes::interpolation() {
  CauseShares out;
  out.cause = "particle-grid interpolation";
  out.note = "the reference passed through the candidate's nodes, shape functions and points";
  out.value = on_cells - truth;
  out.value[cumulative_flux] = 0;
  out.value[stored_water] = water_passed_through() - truth[stored_water];
  if (std::isfinite(out.value[stored_water])) return out;
  out.value[stored_water] = 0;
  out.note += " (not for stored water: several soils)";
  return out;
}

double Probes::water_passed_through() const {
  const auto& reference = it_.reference.reference.history;
  if (it_.scene.soils.size() > 1 || index_ >= reference.snapshots.size()) return std::nan("");
  const fem_reference::SoilLaw law(problem_.soils[0], problem_.unit_weight);
  const meshes::Mesh& mesh = it_.candidate.mesh;
  const std::vector<double> nodal = pressure_at_nodes(reference, mesh)[index_];
  const meshes::Snapshot& snapshot = it_.candidate.snapshots[index_];
  const auto content = [&](double pressure) {
    return law.porosity() * law.saturation(pressure / problem_.unit_weight);
  };
  double water = 0, volume = 0;
  const auto& points = snapshot.points.position;
  if (snapshot.cells_hold_averages && !points.empty()) {
    const meshes::Evaluator evaluate(mesh);
    for (std::size_t c = 0; c < mesh.cell_count(); ++c) volume += mesh.cell_measure(c);
    for (const meshes::Point& point : points)
      water += volume / static_cast<double>(points.size()) * content(evaluate(nodal, point));
  } else {
    for (std::size_t c = 0; c < mesh.cell_count(); ++c)
      for (const int node : mesh.cell(c))
        water += mesh.cell_measure(c) / static_cast<double>(mesh.cell(c).size()) * content(nodal[node]);
  }
  return water / ledger_area(it_.scene, mesh);
}

/// What the candidate's own refinement changes, up to its limit.
CauseShares Probes::limit(const std::string& cause, const std::string& what, int Rerun::*part, double cost_factor) {
  if (!it_.rerun) return unprobed(cause, "a stored result cannot be run again");
  const double cost = it_.candidate.cpu_seconds * cost_factor;
  if (cost > probe_budget) return unprobed(cause, fmt::format("a finer run is expected to take {:.0f} CPU-s", cost));
  Rerun once, twice;
  once.*part = 1;
  twice.*part = 2;
  const auto finer = again(what, once);
  if (!finer) return unprobed(cause, "the finer run gave up or was refused (see the log)");
  const Quantities second = read_(*finer, it_.candidate);
  std::optional<meshes::FieldHistory> finest;
  if (finer->cpu_seconds * cost_factor <= probe_budget) finest = again(what + ", once more", twice);
  if (finest) {
    CauseShares out = limit_share(cause, candidate, second, read_(*finest, it_.candidate), truth);
    out.note = "the candidate run again " + what + " and once more";
    return out;
  }
  CauseShares out;  // at first order the rest is as large as the change
  out.cause = cause;
  out.note = "the candidate run again " + what + ", once only for its cost: first order is assumed";
  const Quantities change = candidate - second;
  for (int q = 0; q < explained_quantities; ++q) out.value[q] = 2 * change[q], out.uncertainty[q] = std::abs(change[q]);
  return out;
}

bool Probes::beyond_richards() const {
  return std::ranges::any_of(it_.scene.stages,
                             [](const Stage& stage) { return stage.scheme && *stage.scheme != Scheme::seepage; }) ||
         deforms(it_.scene);
}

CauseShares Probes::physics() {
  const std::string cause = "physics outside Richards";
  CauseShares out;
  out.cause = cause;
  if (it_.rerun && !beyond_richards()) {
    out.note = "the scene has none: no inertia, a rigid skeleton, and both solvers know the water's compressibility";
    return out;
  }
  Rerun rerun;
  rerun.richards_only = true;
  const auto history = again("the candidate without inertia and deformation", rerun);
  if (!history)
    return unprobed(cause,
                    it_.rerun ? "the run gave up or was refused (see the log)" : "a stored result cannot be run again");
  out.note = "the candidate run again without inertia of the water and deformation of the skeleton";
  out.value = candidate - read_(*history, it_.candidate);
  return out;
}

}  // namespace wetfront::verification
