#include "verification/study/accuracy.h"

#include "verification/compare/profile.h"
#include "verification/scene/read.h"
#include "verification/translate/timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

struct Count {
  std::string path;
  int cells;
};

std::vector<Count> cell_counts(const Scene& scene) {
  const Shape& shape = scene.geometry.shape;
  if (const auto* column = std::get_if<Column>(&shape)) return {{"geometry.column.cells", column->cells}};
  if (const auto* slope = std::get_if<Slope>(&shape))
    return {{"geometry.slope.cells_along", slope->cells_along}, {"geometry.slope.cells_over", slope->cells_over}};
  if (const auto* profile = std::get_if<GroundProfile>(&shape))
    return {{"geometry.profile.cells_along", profile->cells_along},
            {"geometry.profile.cells_over", profile->cells_over}};
  if (const auto* box = std::get_if<Box>(&shape)) {
    std::vector<Count> counts;
    for (std::size_t i = 0; i < box->cells.size(); ++i)
      counts.push_back({"geometry.box.cells[" + std::to_string(i) + "]", box->cells[i]});
    return counts;
  }
  throw SceneError({scene.geometry.origin.text() +
                    ": what accuracy costs cannot be studied on a mesh of your own (its cells cannot be halved from "
                    "here). Describe the ground by a shape."});
}

struct SchemeChoice {
  std::string name;
  std::vector<Setting> settings;
};

/// Of the last stage. Explicit drag is as exact as implicit drag, at many times its cost: its plan says how many.
std::vector<SchemeChoice> schemes(const Scene& scene) {
  if (!scene.water) return {{"dynamics", {}}};
  const std::string stage = "stage[" + std::to_string(scene.stages.size() - 1) + "].";
  const std::string scheme = stage + "scheme", integrator = stage + "time_integrator",
                    tolerance = stage + "time_tolerance";
  const bool rigid = std::ranges::none_of(scene.soils, [](const Soil& soil) { return soil.elastic.has_value(); });
  std::vector<SchemeChoice> all;
  if (rigid) {
    all.push_back({"seepage, bdf2", {{scheme, "seepage"}, {integrator, ""}}});
    all.push_back({"seepage, backward-euler", {{scheme, "seepage"}, {integrator, "backward-euler"}}});
    all.push_back({"semi-implicit", {{integrator, ""}, {scheme, "semi-implicit"}}});
  }
  for (const char* name : {"implicit-drag", "explicit"})
    all.push_back({name, {{integrator, ""}, {tolerance, ""}, {scheme, name}}});
  return all;
}

StudyPoint named(const std::string& name, std::vector<Setting> settings) {
  return {name, std::move(settings)};
}

class Builder {
 public:
  explicit Builder(const Scene& scene) : scene_(scene), counts_(cell_counts(scene)) {}

  std::vector<AccuracyPoint> all() {
    const auto choices = schemes(scene_);
    for (const SchemeChoice& choice : choices)
      for (const double factor : {0.25, 0.5, 1.0, 2.0, 4.0}) add(choice, choice.name, factor, {}, "");
    const SchemeChoice& base = choices.front();
    const std::string stage = "stage[" + std::to_string(scene_.stages.size() - 1) + "].";
    if (base.name.starts_with("seepage"))
      for (const char* tolerance : {"1e-2", "1e-3", "1e-4", "1e-6"})
        add(base, "time tolerance", 1, {{stage + "time_tolerance", tolerance}},
            std::string(", tolerance ") + tolerance);
    for (const char* points : {"9", "16"})
      add(base, "points per cell", 1, {{"mpm.points_per_cell", points}}, std::string(", points per cell ") + points);
    if (std::ranges::any_of(scene_.soils, [](const Soil& soil) { return soil.elastic.has_value(); }))
      add(base, "shape functions", 1, {{"skeleton.shape", "quadratic-spline"}}, ", quadratic splines");
    return std::move(points_);
  }

 private:
  void add(const SchemeChoice& choice, const std::string& curve, double factor, const std::vector<Setting>& more,
           const std::string& suffix) {
    AccuracyPoint one;
    one.curve = curve;
    one.cells = factor;
    std::vector<Setting> settings = choice.settings;
    std::string cells;
    for (const Count& count : counts_) {
      const double wanted = count.cells * factor;
      if (wanted != std::floor(wanted) || wanted < 2) return;  // not a mesh of this family
      settings.push_back({count.path, fmt::format("{:.0f}", wanted)});
      cells += (cells.empty() ? "" : " x ") + settings.back().value;
    }
    settings.insert(settings.end(), more.begin(), more.end());
    one.point = named(choice.name + ", " + cells + " cells" + suffix, std::move(settings));
    points_.push_back(std::move(one));
  }

  const Scene& scene_;
  std::vector<Count> counts_;
  std::vector<AccuracyPoint> points_;
};

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

std::vector<AccuracyPoint> accuracy_points(const Scene& scene) {
  return Builder(scene).all();
}

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
