#include "reports/write.h"
#include "verification/commands/commands.h"
#include "verification/compare/verdict.h"
#include "verification/run/run_scene.h"
#include "verification/scene/quantities.h"
#include "verification/scene/read.h"
#include "verification/study/accuracy.h"
#include "verification/study/study.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <stdexcept>

namespace wetfront::verification::commands {
namespace {

/// Output folder of each scene; two scenes may not share one.
std::map<std::filesystem::path, std::filesystem::path> folders_for(const Paths& scenes,
                                                                   const std::filesystem::path& out) {
  std::map<std::filesystem::path, std::filesystem::path> folder_of, scene_of;
  for (const auto& scene : scenes) {
    const std::filesystem::path root = out.empty() ? std::filesystem::path("out") : out;
    const auto folder = scenes.size() == 1 && !out.empty() ? out : root / case_name(scene);
    if (!scene_of.emplace(folder, scene).second)
      throw std::invalid_argument(
          fmt::format("{} and {} would both write to {} (their names are alike). Run them one by "
                      "one with --out",
                      scene_of[folder].string(), scene.string(), folder.string()));
    folder_of[scene] = folder;
  }
  return folder_of;
}

/// Settings that a study of accuracy found cheapest for what is asked, with a sentence about it; nothing where no study
/// is kept that has one.
struct Chosen {
  std::vector<Setting> settings;
  std::string sentence;
};
std::optional<Chosen> chosen_by_study(const Scene& scene, const RunRequest& request, double accuracy) {
  if (!scene.reference || std::holds_alternative<MeshFile>(scene.geometry.shape)) return {};
  const std::string quantity = request.quantity.empty() ? "pressure_l2" : request.quantity;
  const auto folder = request.study.empty() ? std::filesystem::path("out") / ("study_accuracy_" + case_name(scene.path))
                                            : request.study;
  std::vector<StudyPoint> points;
  for (AccuracyPoint& one : accuracy_points(scene)) points.push_back(std::move(one.point));
  std::vector<PointResult> results;
  std::vector<StudyPoint> of;
  const auto kept = kept_points(scene.path, points, folder);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept[i]) {
      results.push_back(*kept[i]);
      of.push_back(points[i]);
    }
  if (results.empty()) return {};
  const auto best = cheapest(results, quantity, accuracy);
  if (!best && quantity == "pressure_l2")  // what refinement can reach by itself
    return Chosen{
        {},
        fmt::format("accuracy {} of {} was asked for; none of the {} settings studied in {} reaches it (the "
                    "finest is not fine enough), so the MPM is refined until its own estimated error does",
                    amount(accuracy, find_quantity(quantity)->unit), quantity, results.size(), folder.string())};
  if (!best)
    throw std::invalid_argument(
        fmt::format("--accuracy: none of the {} settings studied in {} brings {} within {:g} (the "
                    "finest is not fine enough). Give the scene more cells and study it again",
                    results.size(), folder.string(), quantity, accuracy));
  const std::string unit = find_quantity(quantity)->unit;
  return Chosen{
      of[*best].settings,
      fmt::format("accuracy {} of {} was asked for; of the {} settings studied in {} the cheapest that reaches "
                  "it is '{}': {} there, {:.3g} CPU-s",
                  amount(accuracy, unit), quantity, results.size(), folder.string(), of[*best].name,
                  amount(bounded_error_of(results[*best], quantity), unit), results[*best].candidate_cpu)};
}

/// The scene as it is to be run: with what was set and, where a study knows, with what reaches the accuracy.
Scene scene_for(const std::filesystem::path& path, const RunRequest& request, RunOptions& options) {
  const std::vector<Setting> settings = read_settings(request.settings);
  Scene scene = read_scene(path, settings);
  if (!(options.accuracy > 0)) return scene;
  if (!settings.empty()) return scene;  // studied as the file has it
  const auto chosen = chosen_by_study(scene, request, options.accuracy);
  if (!chosen && !request.quantity.empty() && request.quantity != "pressure_l2")
    throw std::invalid_argument("--quantity " + request.quantity +
                                ": no study of accuracy of this scene is kept (what the "
                                "program finds by itself is an accuracy of pressure). Run `wetfront study accuracy " +
                                path.string() + "` first");
  if (!chosen) return scene;
  options.notes.push_back(chosen->sentence);
  fmt::print("{}\n", chosen->sentence);
  if (chosen->settings.empty()) return scene;
  options.accuracy = 0;
  return read_scene(path, chosen->settings);
}

}  // namespace

int run(const Paths& scenes, const std::filesystem::path& out, const RunRequest& request) {
  if (!request.quantity.empty() && !find_quantity(request.quantity))
    throw std::invalid_argument("--quantity " + request.quantity +
                                ": there is no such quantity (a tolerance could not be "
                                "put on it either). SCENE.md lists them");
  if (!request.quantity.empty() && find_quantity(request.quantity)->unit != "1")
    throw std::invalid_argument("--quantity " + request.quantity + ": its errors are told in " +
                                find_quantity(request.quantity)->unit + " (an accuracy is relative). Name another");
  const auto folder_of = folders_for(scenes, out);
  std::vector<Scene> read;  // all of them before any is run: a typo in the last must not cost the first
  std::vector<RunOptions> options(scenes.size(), request.options);
  for (std::size_t i = 0; i < scenes.size(); ++i) read.push_back(scene_for(scenes[i], request, options[i]));
  Exit worst = Exit::pass;
  std::vector<std::filesystem::path> done;
  for (std::size_t i = 0; i < read.size(); ++i) {
    const Scene& scene = read[i];
    const auto& folder = folder_of.at(scene.path);
    const RunResult result = run_scene(scene, folder, options[i]);
    fmt::print("{}: {}, {:.2f} CPU-s (MPM {:.2f}) -> {}\n", result.record.case_name, word(result.record.verdict),
               result.record.cpu_seconds, result.candidate.history.cpu_seconds, (folder / "report.html").string());
    for (const std::string& reason : why_given_up(result)) fmt::print(stderr, "  gave up: {}\n", reason);
    print_findings(result.record);
    worst = worse(worst, result.exit);
    done.push_back(folder);
    if (result.stopped) {
      if (i + 1 < read.size()) fmt::print(stderr, "stopped as asked: {} more not run\n", read.size() - i - 1);
      break;
    }
  }
  if (done.size() > 1) {
    const auto page = (out.empty() ? std::filesystem::path("out") : out) / "index.html";
    reports::write_index(done, page, "wetfront: " + std::to_string(done.size()) + " scenes");
    fmt::print("index of all runs -> {}\n", page.string());
  }
  return static_cast<int>(worst);
}

}  // namespace wetfront::verification::commands
