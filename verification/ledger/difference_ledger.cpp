#include "verification/ledger/difference_ledger.h"

#include "verification/compare/gates.h"
#include "verification/compare/outcomes.h"
#include "verification/compare/verdict.h"
#include "verification/ledger/probes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace wetfront::verification {
namespace {

/// The last comparison time that both reached and, in a column, at which both still have a front.
std::size_t time_to_explain(const Explained& it) {
  const std::size_t times = std::min(it.candidate.snapshots.size(), it.reference.reference.history.snapshots.size());
  if (times == 0) throw std::runtime_error("a ledger of differences needs a time at which both solutions have fields");
  const auto a = fronts(it.scene, it.candidate, it.candidate),
             b = fronts(it.scene, it.reference.reference.history, it.candidate);
  for (std::size_t t = times; t-- > 0;)
    if (t < a.size() && t < b.size() && std::isfinite(a[t]) && std::isfinite(b[t])) return t;
  return times - 1;
}

struct About {
  const char *name, *description, *gate;
};
constexpr About about[explained_quantities] = {
    {"front_position", "elevation of the wetting front", "front_position"},
    {"stored_water", "stored water", "cumulative_infiltration"},
    {"cumulative_flux", "water taken since the start", "cumulative_infiltration"}};

constexpr double negligible_of_gate = 0.1, negligible_of_value = 1e-4;

/// Below it there is nothing to explain.
double trifle_of(const QuantityLedger& entry) {
  return std::max(negligible_of_gate * entry.tolerance, negligible_of_value * std::abs(entry.reference));
}

/// Mean share of what there is to explain.
std::vector<std::pair<std::string, double>> ranked(const std::vector<QuantityLedger>& quantities) {
  std::map<std::string, double> sum;
  int counted = 0;
  for (const QuantityLedger& entry : quantities) {
    const double size = entry.size();
    if (size <= trifle_of(entry)) continue;
    ++counted;
    for (const Share& share : entry.shares) sum[share.cause] += std::abs(share.value) / size;
    sum["remainder"] += std::abs(entry.remainder) / size;
  }
  std::vector<std::pair<std::string, double>> causes(sum.begin(), sum.end());
  for (auto& [cause, share] : causes) share /= counted;
  std::ranges::stable_sort(causes, [](const auto& a, const auto& b) { return a.second > b.second; });
  return causes;
}

}  // namespace

void conclude(QuantityLedger& entry) {
  using reports::Verdict;
  double sum = 0;
  bool converged = true;
  for (const Share& share : entry.shares) {
    sum += share.value;
    entry.uncertainty += share.uncertainty;
    if (!share.converged && share.uncertainty > 0.1 * entry.size()) converged = false;
  }
  entry.uncertainty += entry.reference_bound;
  entry.remainder = entry.difference() - sum;
  const double size = entry.size(), allowed = small_remainder * size;
  entry.cancels = size - std::abs(entry.remainder) > 2 * std::abs(entry.difference());
  const double trifle = trifle_of(entry);
  if (size <= trifle) {
    entry.verdict = Verdict::pass;
    entry.explanation = "There is nothing to explain: what there is lies within a tenth of the gate.";
  } else if (!converged) {
    entry.verdict = Verdict::inconclusive;
    entry.explanation = "A probe run does not approach a limit, so its share is not known.";
  } else {
    // A remainder below what matters is none; the probes' own doubt decides between the rest.
    const double rest = std::abs(entry.remainder);
    entry.verdict = rest <= trifle ? Verdict::pass : verdict(rest, std::min(entry.uncertainty, allowed), allowed);
    const bool all_probed = std::ranges::all_of(entry.shares, &Share::probed);
    if (entry.verdict == Verdict::fail && !all_probed) {
      entry.verdict = Verdict::inconclusive;
      entry.explanation = "A large part is not explained; it may be a cause that could not be measured here.";
    } else if (entry.verdict == Verdict::fail) {
      entry.explanation = "Something that no probe knows makes a large part of the difference.";
    }
  }
  if (entry.cancels && size > trifle)
    entry.explanation += std::string(entry.explanation.empty() ? "" : " ") +
                         "Causes of opposite sign hide each other: the difference is smaller than what makes it.";
}

double QuantityLedger::size() const {
  double sum = 0, all = 0;
  for (const Share& share : shares) sum += share.value, all += std::abs(share.value);
  return all + std::abs(difference() - sum);
}

DifferenceLedger difference_ledger(const Explained& it) {
  const std::size_t index = time_to_explain(it);
  Probes probes(it, index);
  const std::vector<CauseShares> found = probes.all();
  DifferenceLedger ledger;
  ledger.time = it.timeline.comparison_times[index];
  for (int q = 0; q < explained_quantities; ++q) {
    if (!std::isfinite(probes.candidate[q]) || !std::isfinite(probes.truth[q])) continue;
    QuantityLedger entry;
    entry.quantity = about[q].name;
    entry.description = about[q].description;
    entry.unit = "m";
    entry.candidate = probes.candidate[q];
    entry.reference = probes.truth[q];
    entry.reference_bound = probes.bound[q];
    entry.reference_mesh = probes.of_the_reference("reference's mesh", probes.by_finer_cells, mesh_safety, q);
    entry.reference_steps = probes.of_the_reference("reference's time step", probes.by_tighter_steps, step_safety, q);
    entry.tolerance = gate_on(it.scene, about[q].gate, probes.truth[q]);
    for (const CauseShares& cause : found)
      entry.shares.push_back(
          {cause.cause, cause.value[q], cause.uncertainty[q], cause.converged[q], cause.probed, cause.note});
    for (Share& share : entry.shares)
      if (!std::isfinite(share.value))
        share.value = 0, share.probed = false, share.note += " (a probe run has no such quantity)";
    conclude(entry);
    ledger.quantities.push_back(std::move(entry));
  }
  ledger.causes = ranked(ledger.quantities);
  ledger.cpu_seconds = probes.cpu_seconds;
  ledger.log = probes.log;
  return ledger;
}

}  // namespace wetfront::verification
