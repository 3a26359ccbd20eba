#include "verification/compare/verdict.h"

#include "verification/scene/quantities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace wetfront::verification {
namespace {

using reports::Finding;
using reports::Verdict;

std::string group_of(const Quantity& quantity) {
  switch (quantity.per) {
    case Quantity::Per::time:
      return "Fields";
    case Quantity::Per::probe:
      return "Gauges";
    case Quantity::Per::run:
      return "Run";
  }
  return "Run";
}

Finding finding_of(const Measurement& measurement, double cpu_seconds) {
  const Quantity& quantity = *find_quantity(measurement.quantity);
  Finding finding;
  finding.quantity = measurement.quantity;
  finding.description = measurement.description;
  finding.group = group_of(quantity);
  finding.unit = quantity.unit;
  finding.error = measurement.error;
  finding.reference_bound = measurement.reference.bound;
  finding.reference_convergence = word(measurement.reference.convergence);
  finding.reference_order = measurement.reference.order;
  finding.cpu_s = cpu_seconds;
  finding.explanation = measurement.explanation;
  return finding;
}

bool answers(const Measurement& measurement, const Tolerance& tolerance, double at, const Timeline& timeline) {
  if (measurement.quantity != tolerance.quantity) return false;
  if (!tolerance.probe.empty() && measurement.probe != tolerance.probe) return false;
  if (std::isnan(at) || measurement.time_index < 0) return true;
  return std::abs(timeline.comparison_times[measurement.time_index] - at) <= 1e-9 * std::max(1.0, at);
}

/// Of several tolerances that fit, the one that names the time or probe counts.
int specificity(const Tolerance& tolerance) {
  return (tolerance.at ? 1 : 0) + (tolerance.probe.empty() ? 0 : 1);
}

void judge_finding(Finding& finding, const Tolerance& tolerance) {
  finding.tolerance = tolerance.value;
  finding.reason = tolerance.reason;
  finding.verdict = verdict(finding.error, finding.reference_bound, finding.tolerance);
  if (std::isnan(finding.error)) finding.explanation = "it happened in neither solution before the end of the run";
  if (std::isinf(finding.error)) finding.explanation += " (it happened in only one of them)";
  if (finding.reference_bound > finding.tolerance / 10 && finding.verdict == Verdict::inconclusive)
    finding.explanation += " (the reference is not fine enough for this tolerance: raise [reference] cells)";
}

Finding unanswered(const Tolerance& tolerance) {
  Finding finding;
  const Quantity& quantity = *find_quantity(tolerance.quantity);
  finding.quantity = tolerance.quantity;
  finding.description = quantity.meaning + (tolerance.probe.empty() ? "" : " (probe " + tolerance.probe + ")");
  finding.group = group_of(quantity);
  finding.unit = quantity.unit;
  finding.error = std::nan("");
  finding.tolerance = tolerance.value;
  finding.reason = tolerance.reason;
  finding.verdict = Verdict::inconclusive;
  finding.explanation =
      "nothing to measure: this quantity does not exist in this run (" + tolerance.origin.text() + ")";
  return finding;
}

/// Order on the page: by group, gates before what is only shown, then as the table of quantities lists them.
std::array<std::ptrdiff_t, 3> rank(const Finding& finding) {
  const Quantity* quantity = find_quantity(finding.quantity);
  return {static_cast<std::ptrdiff_t>(quantity->per), finding.verdict == Verdict::info ? 1 : 0,
          quantity - quantities().data()};
}

}  // namespace

std::vector<Finding> judge(const Scene& scene, const Timeline& timeline, const std::vector<Measurement>& measurements,
                           double cpu_seconds) {
  const auto& tolerances = scene.comparison.tolerances;
  std::vector<bool> answered(tolerances.size(), false);
  std::vector<Finding> findings;
  for (const Measurement& measurement : measurements) {
    const Tolerance* chosen = nullptr;
    for (std::size_t i = 0; i < tolerances.size(); ++i) {
      if (!answers(measurement, tolerances[i], timeline.tolerance_times[i], timeline)) continue;
      // A tolerance on all times or probes is answered by those at which the quantity exists.
      if (std::isnan(measurement.error) && specificity(tolerances[i]) == 0) continue;
      answered[i] = true;
      if (!chosen || specificity(tolerances[i]) > specificity(*chosen)) chosen = &tolerances[i];
    }
    if (!chosen && std::isnan(measurement.error)) continue;
    Finding finding = finding_of(measurement, cpu_seconds);
    if (chosen) judge_finding(finding, *chosen);
    findings.push_back(std::move(finding));
  }
  for (std::size_t i = 0; i < tolerances.size(); ++i)
    if (!answered[i]) findings.push_back(unanswered(tolerances[i]));
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return rank(a) < rank(b); });
  return findings;
}

}  // namespace wetfront::verification
