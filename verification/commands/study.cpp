#include "verification/study/study.h"
#include "reports/write.h"
#include "verification/commands/commands.h"
#include "verification/compare/verdict.h"
#include "verification/scene/read.h"
#include "verification/study/accuracy.h"
#include "verification/study/effects.h"
#include "verification/study/study_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace wetfront::verification::commands {
namespace {

std::filesystem::path folder_for(const std::string& kind, const StudyRequest& request) {
  if (!request.out.empty()) return request.out;
  return std::filesystem::path("out") / ("study_" + kind + "_" + case_name(request.scene));
}

std::vector<Variation> variations_of(const StudyRequest& request) {
  std::vector<Variation> variations;
  for (const std::string& text : request.settings) variations.push_back(read_variation(text));
  return variations;
}

/// One line per point: its number and what is set.
int list(const std::vector<StudyPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) fmt::print("{}  {}\n", i, points[i].name);
  return 0;
}

int one_point(const StudyRequest& request, const std::vector<StudyPoint>& points, const std::filesystem::path& out) {
  const auto index = static_cast<std::size_t>(request.point);
  if (index >= points.size())
    throw std::invalid_argument(
        fmt::format("--point {}: there is no such point (they are counted from 0 to {}). "
                    "--list shows them",
                    request.point, points.size() - 1));
  const PointResult result =
      run_point(request.scene, points[index], point_folder(out, index, points[index]), request.store);
  fmt::print("point {}  {}: {}\n", index, result.name, verdict_of(result));
  if (!result.message.empty()) fmt::print(stderr, "{}\n", result.message);
  return result.exit;
}

int exit_of(const std::vector<PointResult>& results) {
  const auto any = [&](Exit code) {
    return std::ranges::any_of(results, [&](const auto& result) { return result.exit == static_cast<int>(code); });
  };
  for (const Exit code : {Exit::bad_input, Exit::gave_up, Exit::fail, Exit::inconclusive})
    if (any(code)) return static_cast<int>(code);
  return 0;
}

}  // namespace

int study_vary(const StudyRequest& request) {
  const std::vector<Variation> variations = variations_of(request);
  if (variations.empty())
    throw std::invalid_argument("study vary: nothing is varied (no --set). Add e.g. --set rain.intensity=1e-5,2e-5");
  const std::vector<StudyPoint> points = product(variations);
  for (const StudyPoint& point : points) point_hash(request.scene, point);  // complains of paths that lead nowhere
  if (request.list) return list(points);
  const auto out = folder_for("vary", request);
  if (request.point >= 0) return one_point(request, points, out);
  const auto results = request.gather
                           ? gather_points(request.scene, points, out)
                           : run_points(request.scene, points, {out, request.jobs, request.store, request.command});
  const reports::Record record = vary_page(request.scene, variations, results, out);
  reports::write_result(record, out);
  fmt::print("{} points, {:.2f} CPU-s of the MPM -> {}\n", results.size(), record.cpu_seconds,
             (out / "report.html").string());
  return exit_of(results);
}

int study_accuracy(const StudyRequest& request, double budget) {
  const Scene scene = read_scene(request.scene);
  if (!scene.reference)
    throw SceneError(
        {request.scene.string() + ":1:1: the scene has no reference (errors could not be told). Add [reference]."});
  const auto points = accuracy_points(scene, budget);
  std::vector<StudyPoint> all;
  for (std::size_t i = 0; i < points.size(); ++i) all.push_back(points[i].point);
  if (request.list) return list(all);
  const auto out = folder_for("accuracy", request);
  if (request.point >= 0) return one_point(request, all, out);
  solve_references(scene, timeline(scene), request.store);  // once, before workers would all solve it
  const auto costs = reference_costs(scene, request.store);
  std::vector<bool> wanted;
  for (const AccuracyPoint& point : points) wanted.push_back(!point.expensive);
  const auto results =
      request.gather ? gather_points(request.scene, all, out)
                     : run_points(request.scene, all, {out, request.jobs, request.store, request.command, wanted});
  const reports::Record record = accuracy_page(request.scene, points, results, costs, out);
  reports::write_result(record, out);
  fmt::print("{} settings, {:.2f} CPU-s of the MPM -> {}\n", results.size(), record.cpu_seconds,
             (out / "report.html").string());
  return 0;
}

int study_effects(const StudyRequest& request, double budget) {
  const Scene scene = read_scene(request.scene);
  const auto changes = effect_changes(scene, budget);
  std::vector<StudyPoint> all;
  std::vector<bool> wanted;
  for (const EffectChange& change : changes) all.push_back(change.point), wanted.push_back(!change.expensive);
  if (request.list) return list(all);
  const auto out = folder_for("effects", request);
  if (request.point >= 0) return one_point(request, all, out);
  if (scene.reference) solve_references(scene, timeline(scene), request.store);
  const auto results =
      request.gather ? gather_points(request.scene, all, out)
                     : run_points(request.scene, all, {out, request.jobs, request.store, request.command, wanted});
  const reports::Record record = effects_page(request.scene, changes, results, out);
  reports::write_result(record, out);
  for (const std::string& sentence : stored_effects(scene, out)) fmt::print("  {}\n", sentence);
  fmt::print("{} effects, {:.2f} CPU-s of the MPM -> {}\n", changes.size() - 2, record.cpu_seconds,
             (out / "report.html").string());
  return 0;
}

int study_difference(const StudyRequest& request) {
  const Scene scene = read_scene(request.scene);
  const auto out = folder_for("difference", request);
  const RunResult result = run_scene(scene, out, {request.store, 0, false, true, {}});
  for (const auto& table : result.record.tables)
    if (table.section == "Difference ledger") {
      fmt::print("{}. {}\n", table.title, table.caption);
      for (const auto& row : table.rows) {
        for (std::size_t c = 0; c < row.size(); ++c) fmt::print("{}{:<28}", c ? " " : "  ", row[c]);
        fmt::print("\n");
      }
    }
  fmt::print("{} -> {}\n", word(result.record.verdict), (out / "report.html").string());
  return static_cast<int>(result.exit);
}

}  // namespace wetfront::verification::commands
