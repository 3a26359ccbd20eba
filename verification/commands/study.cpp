#include "verification/study/study.h"
#include "reports/write.h"
#include "verification/commands/commands.h"
#include "verification/compare/body_outcomes.h"
#include "verification/compare/verdict.h"
#include "verification/scene/read.h"
#include "verification/study/accuracy.h"
#include "verification/study/effects.h"
#include "verification/study/safety.h"
#include "verification/study/study_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
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

/// What one kind of study has of its own.
struct Kind {
  std::string name;  ///< "accuracy"
  std::string what;  ///< "12 settings", for the last line
  std::vector<StudyPoint> points;
  std::function<reports::Record(const std::vector<PointResult>&, const std::filesystem::path& out)> page;
  std::function<void()> before = [] {};  ///< once, before workers would all do it
  std::function<void(const std::filesystem::path&)> after = [](const auto&) {};  ///< once the page is there
  double budget = std::numeric_limits<double>::infinity();                       ///< CPU seconds that a point may cost
  std::size_t always = 0;                                                        ///< points at the front, at any cost
  bool verdicts_count = true;
};

/// Once, before workers would all do it.
void solve_its_references(const Scene& scene, const ReferenceStore& store) {
  if (scene.reference) solve_references(scene, timeline(scene), store);
}

/// Lists the points, computes one of them, or all of them or gathers them, with a page over what they left.
int run_study(const StudyRequest& request, const Kind& kind) {
  if (request.list) return list(kind.points);
  const auto out = folder_for(kind.name, request);
  if (request.point >= 0) return one_point(request, kind.points, out);
  if (!request.gather) kind.before();
  const StudyOptions options{out, request.jobs, request.store, request.command, kind.budget, kind.always};
  const auto results = request.gather ? gather_points(request.scene, kind.points, options)
                                      : run_points(request.scene, kind.points, options);
  const reports::Record record = kind.page(results, out);
  reports::write_result(record, out);
  kind.after(out);
  fmt::print("{}, {:.2f} CPU-s of the MPM -> {}\n", kind.what, record.cpu_seconds, (out / "report.html").string());
  Exit worst = Exit::pass;
  if (kind.verdicts_count)
    for (const PointResult& result : results) worst = worse(worst, static_cast<Exit>(result.exit));
  return static_cast<int>(worst);
}

}  // namespace

int study_vary(const StudyRequest& request) {
  const std::vector<Variation> variations = variations_of(request);
  if (variations.empty())
    throw std::invalid_argument("study vary: nothing is varied (no --set). Add e.g. --set rain.intensity=1e-5,2e-5");
  const Scene scene = read_scene(request.scene);
  Kind kind;
  kind.name = "vary";
  kind.points = product(variations);
  kind.what = fmt::format("{} points", kind.points.size());
  for (const StudyPoint& point : kind.points) point_hash(request.scene, point);  // complains of paths that lead nowhere
  kind.page = [&](const auto& results, const auto& out) { return vary_page(scene, variations, results, out); };
  return run_study(request, kind);
}

int study_accuracy(const StudyRequest& request, double budget) {
  const Scene scene = read_scene(request.scene);
  if (!scene.reference && !follows_a_body(scene))
    throw SceneError(
        {request.scene.string() +
         ":1:1: the scene has no reference and follows no body (errors could not be told). Add [reference], or a "
         "[[rider]]."});
  auto points = accuracy_points(scene);
  std::ranges::move(window_points(scene, budget), std::back_inserter(points));
  Kind kind;
  kind.name = "accuracy";
  for (const AccuracyPoint& one : points) kind.points.push_back(one.point);
  kind.what = fmt::format("{} settings", points.size());
  kind.before = [&] { solve_its_references(scene, request.store); };
  kind.page = [&](const auto& results, const auto& out) {
    return accuracy_page(scene, points, results, reference_costs(scene, request.store), out);
  };
  kind.budget = budget;
  kind.verdicts_count = false;  // coarse settings are meant to miss
  return run_study(request, kind);
}

int study_effects(const StudyRequest& request, double budget) {
  const Scene scene = read_scene(request.scene);
  const auto changes = affordable(scene, effect_changes(scene), budget);
  Kind kind;
  kind.name = "effects";
  for (const EffectChange& change : changes) kind.points.push_back(change.point);
  kind.what = fmt::format("{} effects",
                          std::ranges::count_if(changes, [](const EffectChange& one) { return !one.how.empty(); }));
  kind.before = [&] { solve_its_references(scene, request.store); };
  kind.page = [&](const auto& results, const auto& out) { return effects_page(scene, changes, results, out); };
  kind.after = [&](const auto& out) {
    for (const std::string& sentence : stored_effects(scene, out)) fmt::print("  {}\n", sentence);
  };
  kind.budget = budget;
  kind.always = 1;  // without the scene itself there is nothing to compare with
  kind.verdicts_count = false;
  return run_study(request, kind);
}

int study_safety(const StudyRequest& request, const std::vector<double>& times, const mpm::SafetySearch& search) {
  const auto out = folder_for("safety", request);
  reports::make_writable(out);
  const Prepared prepared = prepare(read_scene(request.scene));
  const SafetyHistory history = safety_history(prepared, times, search);
  const reports::Record record = safety_page(prepared, history);
  reports::write_result(record, out);
  for (const auto& state : history.states)
    fmt::print("{:>10.6g} s  {:.4g} to {}\n", state.snapshot.time, state.factor.stands,
               state.factor.fails > 0 ? fmt::format("{:.4g}", state.factor.fails) : "more");
  for (const auto& figure : record.figures) fmt::print("{}\n", figure.note);
  if (!history.run.gave_up.empty()) fmt::print(stderr, "{}\n", history.run.gave_up);
  fmt::print("{} factors of safety, {:.2f} CPU-s -> {}\n", history.states.size(), record.cpu_seconds,
             (out / "report.html").string());
  return static_cast<int>(history.run.gave_up.empty() ? Exit::pass : Exit::gave_up);
}

int study_difference(const StudyRequest& request) {
  const Scene scene = read_scene(request.scene);
  const auto out = folder_for("difference", request);
  const RunResult result = run_scene(scene, out, {.store = request.store, .ledger = true});
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
