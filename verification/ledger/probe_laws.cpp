// The shares of the soil's laws: what the candidate behaves as if it had, put into the reference one law at a time.
#include "verification/compare/profile.h"
#include "verification/ledger/observed_soil.h"
#include "verification/ledger/probes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wetfront::verification {
namespace {

constexpr double content_matters = 2e-3;       ///< rms of S: below it the retention curves are the same
constexpr double conductivity_matters = 0.05;  ///< of K: below it what is seen may be the mesh's error
constexpr double cost_of_refinement = 32;      ///< cells and steps at once
constexpr double watch_budget = 60;            ///< CPU seconds that the observed run may be expected to take
constexpr int kept_times = 40;                 ///< at which fields are kept to observe fluxes between them

std::vector<double> times_until(double end) {
  std::vector<double> times;
  for (int i = 0; i <= kept_times; ++i) times.push_back(end * i / kept_times);
  return times;
}

/// The reference as if the candidate's cells had been all there is to see of it.
meshes::FieldHistory seen_in_cells(const meshes::FieldHistory& reference, const meshes::FieldHistory& candidate) {
  meshes::FieldHistory seen = reference;
  seen.mesh = candidate.mesh;
  const auto profiles = profiles_at_cells(reference, candidate);
  seen.snapshots.resize(profiles.size());
  for (std::size_t t = 0; t < profiles.size(); ++t) {
    seen.snapshots[t].cell_pressure = profiles[t].pressure;
    seen.snapshots[t].cell_saturation = profiles[t].saturation;
    seen.snapshots[t].node_pressure.clear();  // of its retention curve there is no doubt
    seen.snapshots[t].node_saturation.clear();
  }
  return seen;
}

CauseShares the_same(const std::string& cause, const std::string& note) {
  CauseShares out;
  out.cause = cause;
  out.note = note + ": the same";
  return out;
}

}  // namespace

/// What the reference makes of its soil with departures put into tables.
std::optional<Quantities> Probes::with_tables(const std::string& what, const ObservedSoil* content,
                                              const ObservedSoil* conductivity) {
  const double driest = *std::ranges::min_element(problem_.initial_head);
  const auto history = reference_with(what, [&](auto& changed) {
    changed.soils[0] = tabulated(problem_.soils[0], problem_.unit_weight, driest, content, conductivity);
  });
  if (!history) return {};
  return read_(*history, it_.candidate);
}

CauseShares Probes::law_share(const std::string& cause, const std::string& note, const ObservedSoil* content,
                              const ObservedSoil* conductivity) {
  if (!in_tables_) in_tables_ = with_tables("the reference with its laws in tables", nullptr, nullptr);
  const auto with =
      in_tables_ ? with_tables("the reference with the observed " + cause, content, conductivity) : std::nullopt;
  if (!with) return unprobed(cause, note + "; the reference gave up or was refused with it (see the log)");
  CauseShares out;
  out.cause = cause;
  out.note = note;
  out.value = *with - *in_tables_;
  for (int q = 0; q < explained_quantities; ++q) out.uncertainty[q] = 0.05 * std::abs(out.value[q]);
  return out;
}

std::vector<CauseShares> Probes::laws() {
  const std::string retention = "retention curve", conductivity = "conductivity";
  const std::string why = it_.scene.soils.size() > 1                                  ? "several soils"
                          : !std::holds_alternative<Column>(it_.scene.geometry.shape) ? "observed in columns only"
                                                                                      : "";
  if (!why.empty()) return {unprobed(retention, why), unprobed(conductivity, why)};
  // What cells and steps do to fluxes is not the law's: observed as finely as may be afforded.
  Rerun watched;
  watched.times = times_until(it_.timeline.comparison_times[index_]);
  double cost = it_.candidate.cpu_seconds * cost_of_refinement;
  for (; watched.finer_cells < 2 && cost <= watch_budget; cost *= cost_of_refinement)
    ++watched.finer_cells, ++watched.finer_steps;
  const auto again_seen = again("the candidate again, finer, its fields kept 40 times", watched);
  const meshes::FieldHistory& seen = again_seen ? *again_seen : it_.candidate;
  const fem_reference::Soil& law = problem_.soils[0];
  ObservedSoil soil = observe(seen, law, problem_.unit_weight, ledger_area(it_.scene, seen.mesh));
  std::string unknown = "too few places where flux and gradient are even enough to tell K";
  if (!soil.conductivity.empty()) {
    const auto reference = reference_with("the reference, its fields kept as often", [&](auto& changed) {
      changed.output_times.clear();
      for (const auto& snapshot : seen.snapshots) changed.output_times.push_back(snapshot.time);
    });
    if (reference)
      relate_to(soil, observe(seen_in_cells(*reference, seen), law, problem_.unit_weight,
                              ledger_area(it_.scene, reference->mesh)));  // its ledger is that of its own mesh
    else
      soil.conductivity.clear(), unknown = "the reference gave up or was refused with its fields kept as often";
  }
  const std::string content_note =
      fmt::format("S against p in the candidate departs from the reference's curve by {:.2g} (rms)", soil.content_rms);
  std::vector<CauseShares> found{soil.content_rms < content_matters
                                     ? the_same(retention, content_note)
                                     : law_share(retention, content_note, &soil, nullptr)};
  if (soil.conductivity.empty()) {
    found.push_back(unprobed(conductivity, unknown));
    return found;
  }
  const auto [low, high] = std::ranges::minmax(soil.conductivity);
  const std::string k_note = fmt::format(
      "K at the same saturation is {:.2f} to {:.2f} times what is observed of the reference in the same way, "
      "at {} places and times",
      low, high, soil.flux_samples);
  const bool matters = high > 1 + conductivity_matters || low < 1 - conductivity_matters;
  found.push_back(matters ? law_share(conductivity, k_note, nullptr, &soil) : the_same(conductivity, k_note));
  return found;
}

}  // namespace wetfront::verification
