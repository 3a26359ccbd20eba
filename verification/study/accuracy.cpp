#include "verification/study/accuracy.h"

#include "verification/compare/profile.h"
#include "verification/translate/timeline.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace wetfront::verification {
namespace {

double largest(const PointResult& result, const std::string& quantity, bool with_bound) {
  double worst = std::numeric_limits<double>::quiet_NaN();
  for (const auto& finding : result.findings) {
    if (finding.quantity != quantity || std::isnan(finding.error)) continue;
    const double error = finding.error + (with_bound ? finding.reference_bound : 0);
    if (!(error <= worst)) worst = error;
  }
  return worst;
}

}  // namespace

double error_of(const PointResult& result, const std::string& quantity) {
  return largest(result, quantity, false);
}
double bounded_error_of(const PointResult& result, const std::string& quantity) {
  return largest(result, quantity, true);
}

std::vector<double> errors_of(const std::vector<PointResult>& results, const std::string& quantity) {
  std::vector<double> errors;
  for (const PointResult& result : results) errors.push_back(error_of(result, quantity));
  return errors;
}

std::optional<std::size_t> cheapest(const std::vector<PointResult>& results, const std::string& quantity,
                                    double target) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < results.size(); ++i)
    if (results[i].ran() && bounded_error_of(results[i], quantity) <= target &&
        (!best || results[i].candidate_cpu < results[*best].candidate_cpu))
      best = i;
  return best;
}

Convergence convergence_of(const std::vector<double>& errors) {
  if (errors.size() < 2) return Convergence::none;
  if (!(errors.back() < errors.front())) return Convergence::divergent;
  return std::ranges::is_sorted(errors, std::greater()) ? Convergence::monotone : Convergence::oscillatory;
}

std::vector<std::size_t> pareto(const std::vector<PointResult>& results, const std::vector<double>& errors) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < results.size(); ++i)
    if (results[i].ran() && std::isfinite(errors[i])) order.push_back(i);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return results[i].candidate_cpu; });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || errors[i] < errors[front.back()]) front.push_back(i);
  return front;
}

std::vector<std::size_t> pareto(const std::vector<PointResult>& results, const std::string& quantity) {
  return pareto(results, errors_of(results, quantity));
}

std::optional<std::size_t> finest_with(const std::vector<AccuracyPoint>& points,
                                       const std::vector<PointResult>& results, const std::string& outcome) {
  std::optional<std::size_t> finest;
  int count = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    if (!results[i].ran() || std::isnan(value_of(results[i].candidate, outcome))) continue;
    ++count;
    if (!finest || points[i].cells > points[*finest].cells) finest = i;
  }
  return count > 1 ? finest : std::nullopt;
}

std::vector<double> changes_from(const std::vector<PointResult>& results, std::size_t yardstick,
                                 const std::string& outcome) {
  const double wanted = value_of(results[yardstick].candidate, outcome);
  std::vector<double> changes;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const bool counts = i != yardstick && results[i].ran();
    changes.push_back(counts ? std::abs(value_of(results[i].candidate, outcome) / wanted - 1) : std::nan(""));
  }
  return changes;
}

std::vector<ReferenceCost> reference_costs(const Scene& scene, const ReferenceStore& store) {
  if (!scene.reference) return {};
  const Timeline times = timeline(scene);
  const auto on = [&](int cells) {
    Scene asked = scene;
    asked.reference->cells = cells;
    return solve_reference(asked, times, store).history;
  };
  // Tenths of a second are told by the least of three: a machine that is shared only ever adds.
  const auto timed = [&](int cells) {
    meshes::FieldHistory kept = on(cells);
    for (int again = 0; again < 2 && kept.cpu_seconds < 2; ++again) {
      Scene asked = scene;
      asked.reference->cells = cells;
      kept.cpu_seconds = std::min(kept.cpu_seconds, solve_reference(asked, times, {}).history.cpu_seconds);
    }
    return kept;
  };
  const int base = scene.reference->cells;
  const meshes::FieldHistory finest = on(2 * base);
  std::vector<ReferenceCost> costs;
  for (int cells = base; cells >= std::max(base / 16, 4); cells /= 2) {
    const meshes::FieldHistory coarse = timed(cells);
    const auto of_coarse = pressure_at_nodes(finest, coarse.mesh);
    const std::vector<double> alike(coarse.mesh.node_count(), 1);
    double worst = 0;
    for (std::size_t t = 0; t < std::min(of_coarse.size(), coarse.snapshots.size()); ++t)
      worst = std::max(worst, relative_l2(coarse.snapshots[t].node_pressure, of_coarse[t], alike));
    costs.push_back({cells, coarse.cpu_seconds, worst});
  }
  return costs;
}

}  // namespace wetfront::verification
