#include "verification/study/accuracy.h"

#include "verification/compare/profile.h"
#include "verification/translate/timeline.h"

#include <algorithm>
#include <cmath>
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

bool finished(const PointResult& result) {
  return result.exit != static_cast<int>(Exit::bad_input) && result.exit != static_cast<int>(Exit::gave_up);
}

}  // namespace

double error_of(const PointResult& result, const std::string& quantity) {
  return largest(result, quantity, false);
}
double bounded_error_of(const PointResult& result, const std::string& quantity) {
  return largest(result, quantity, true);
}

std::optional<std::size_t> cheapest(const std::vector<PointResult>& results, const std::string& quantity,
                                    double target) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < results.size(); ++i)
    if (finished(results[i]) && bounded_error_of(results[i], quantity) <= target &&
        (!best || results[i].candidate_cpu < results[*best].candidate_cpu))
      best = i;
  return best;
}

std::vector<std::size_t> pareto(const std::vector<PointResult>& results, const std::string& quantity) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < results.size(); ++i)
    if (finished(results[i]) && std::isfinite(error_of(results[i], quantity))) order.push_back(i);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return results[i].candidate_cpu; });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || error_of(results[i], quantity) < error_of(results[front.back()], quantity)) front.push_back(i);
  return front;
}

std::vector<ReferenceCost> reference_costs(const Scene& scene, const ReferenceStore& store) {
  const Timeline times = timeline(scene);
  const auto on = [&](int cells) {
    Scene asked = scene;
    asked.reference->cells = cells;
    return solve_reference(asked, times, store).history;
  };
  const int base = scene.reference->cells;
  const meshes::FieldHistory finest = on(2 * base);
  std::vector<ReferenceCost> costs;
  for (int cells = base; cells >= std::max(base / 16, 4); cells /= 2) {
    const meshes::FieldHistory coarse = on(cells);
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
