#include "verification/study/point_result.h"

#include "mpm/plan.h"
#include "reports/whole_file.h"
#include "reports/write.h"
#include "verification/compare/body_outcomes.h"
#include "verification/scene/read.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace wetfront::verification {
namespace {

using Json = nlohmann::json;

Json json_of(const std::vector<Outcome>& outcomes) {
  Json list = Json::array();
  for (const Outcome& one : outcomes)
    list.push_back({{"name", one.name},
                    {"description", one.description},
                    {"unit", one.unit},
                    {"value", std::isfinite(one.value) ? Json(one.value) : Json(nullptr)}});
  return list;
}

std::vector<Outcome> outcomes_from(const Json& list) {
  std::vector<Outcome> outcomes;
  for (const Json& one : list)
    outcomes.push_back(
        {one.at("name"), one.at("description"), one.at("unit"),
         one.at("value").is_null() ? std::numeric_limits<double>::quiet_NaN() : one.at("value").get<double>()});
  return outcomes;
}

Json json_of(const PointResult& result) {
  return {{"name", result.name},
          {"hash", result.hash},
          {"exit", result.exit},
          {"message", result.message},
          {"candidate_cpu_s", result.candidate_cpu},
          {"point_bytes", result.point_bytes},
          {"candidate", json_of(result.candidate)},
          {"reference", json_of(result.reference)}};
}

/// What came out of the slide first, then what came out of the ground.
std::vector<Outcome> all_outcomes(const Scene& scene, const Timeline& times, const Solved& solved) {
  std::vector<Outcome> all = outcomes(scene, times, solved.history, solved.history);
  if (!follows_a_body(scene)) return all;
  std::vector<Outcome> slide = body_outcomes(scene, solved.history, solved.body);
  std::erase_if(slide, [&all](const Outcome& one) { return find_outcome(all, one.name) != nullptr; });
  all.insert(all.begin(), slide.begin(), slide.end());
  return all;
}

/// Whether a run of this scene was cut in this folder; of another scene's nothing is left.
bool was_cut(const Scene& scene, const std::filesystem::path& folder) {
  const CheckpointFile file = checkpoint_of(scene, folder);
  std::string note;
  if (scene.mpm.accuracy <= 0 && read_checkpoint(file, note)) return true;
  forget_checkpoint(file);
  return false;
}

/// False: stopped on the way, as asked.
bool fill(PointResult& result, Scene scene, const std::filesystem::path& folder, const ReferenceStore& store) {
  scene.comparison.second_mesh = 1;  // a study has points for that
  std::erase_if(scene.comparison.tolerances,
                [](const Tolerance& gate) { return gate.quantity == "failure_time_mesh"; });
  RunOptions options{store};
  options.resume = was_cut(scene, folder);
  const RunResult run = run_scene(scene, folder, options);
  const Timeline times = timeline(scene);
  result.exit = static_cast<int>(run.exit);
  for (const std::string& reason : why_given_up(run)) result.message += (result.message.empty() ? "" : "; ") + reason;
  result.candidate_cpu = run.candidate.history.cpu_seconds;
  for (const auto& stage : mpm::plan(prepare(scene).problem))
    result.point_bytes = std::max(result.point_bytes, stage.point_bytes);
  result.candidate = all_outcomes(scene, times, run.candidate);
  if (run.reference) result.reference = outcomes(scene, times, run.reference->reference.history, run.candidate.history);
  result.findings = run.record.findings;
  return !run.stopped;
}

}  // namespace

double expected_cpu(const std::filesystem::path& path, const StudyPoint& point) {
  double seconds = 0;
  try {
    Scene asked = read_scene(path, point.settings);
    asked.mpm.cpu_budget = 0;  // to learn what it would take
    for (const auto& stage : mpm::plan(prepare(asked).problem)) seconds += stage.estimated_cpu_seconds;
  } catch (const std::exception&) {
    return 0;
  }
  return seconds;
}

PointResult run_point(const std::filesystem::path& path, const StudyPoint& point, const std::filesystem::path& folder,
                      const ReferenceStore& store) {
  reports::make_writable(folder);
  PointResult result;
  result.name = point.name;
  result.hash = point_hash(path, point);
  std::filesystem::remove(folder / "point.json");
  try {
    if (!fill(result, read_scene(path, point.settings), folder, store)) return result;  // not finished
  } catch (const std::exception& error) {
    result.exit = static_cast<int>(Exit::bad_input);
    result.message = error.what();
    std::filesystem::remove(folder / "result.json");  // of a former version of the point
    std::filesystem::remove(folder / "report.html");
  }
  reports::write_whole(folder / "point.json", json_of(result).dump(1) + "\n");
  return result;
}

std::optional<PointResult> kept_point(const std::filesystem::path& folder, const std::string& hash) {
  if (!std::filesystem::exists(folder / "point.json")) return {};
  try {
    const Json json = Json::parse(reports::read_whole(folder / "point.json"));
    if (json.at("hash") != hash) return {};
    PointResult result;
    result.name = json.at("name");
    result.hash = hash;
    result.exit = json.at("exit");
    result.message = json.at("message");
    result.candidate_cpu = json.at("candidate_cpu_s");
    result.point_bytes = json.at("point_bytes");
    result.candidate = outcomes_from(json.at("candidate"));
    result.reference = outcomes_from(json.at("reference"));
    if (std::filesystem::exists(folder / "result.json"))
      result.findings = reports::read_result(folder / "result.json").findings;
    return result;
  } catch (const Json::exception&) {
    return {};  // not a file of this version: computed again
  }
}

}  // namespace wetfront::verification
