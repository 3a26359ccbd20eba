#include "reports/write.h"
#include "verification/commands/commands.h"
#include "verification/compare/verdict.h"
#include "verification/run/run_scene.h"
#include "verification/scene/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace wetfront::verification::commands {
namespace {

/// The exit code that counts when several scenes ran: what went worst.
int worse(int a, int b) {
  const auto severity = [](int code) {
    switch (static_cast<Exit>(code)) {
      case Exit::pass:
        return 0;
      case Exit::inconclusive:
        return 1;
      case Exit::fail:
        return 2;
      case Exit::gave_up:
        return 3;
      case Exit::bad_input:
        return 4;
    }
    return 4;
  };
  return severity(a) >= severity(b) ? a : b;
}

/// An error or tolerance as people write it: "0.083 %" or "0.0031 m".
std::string amount(double value, const std::string& unit) {
  if (std::isnan(value)) return "nothing to measure";
  if (unit == "1") return fmt::format("{:.3g} %", 100 * value);
  return fmt::format("{:.3g} {}", value, unit);
}

void print_findings(const reports::Record& record) {
  for (const auto& finding : record.findings) {
    if (finding.verdict == reports::Verdict::info) continue;
    fmt::print("  {:<12}  {}: {}, tolerance {}, reference {}\n", word(finding.verdict), finding.description,
               amount(finding.error, finding.unit), amount(finding.tolerance, finding.unit),
               amount(finding.reference_bound, finding.unit));
    if (finding.verdict != reports::Verdict::pass && !finding.explanation.empty())
      fmt::print("                {}\n", finding.explanation);
  }
}

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

}  // namespace

int run(const Paths& scenes, const std::filesystem::path& out, const RunOptions& options) {
  const auto folder_of = folders_for(scenes, out);
  std::vector<Scene> read;  // all of them before any is run: a typo in the last must not cost the first
  for (const auto& path : scenes) read.push_back(read_scene(path));
  int code = 0;
  std::vector<std::filesystem::path> done;
  for (const Scene& scene : read) {
    const auto& folder = folder_of.at(scene.path);
    const RunResult result = run_scene(scene, folder, options);
    fmt::print("{}: {}, {:.2f} CPU-s (MPM {:.2f}) -> {}\n", result.record.case_name, word(result.record.verdict),
               result.record.cpu_seconds, result.candidate.history.cpu_seconds, (folder / "report.html").string());
    for (const std::string& reason : why_given_up(result)) fmt::print(stderr, "  gave up: {}\n", reason);
    print_findings(result.record);
    code = worse(code, static_cast<int>(result.exit));
    done.push_back(folder);
  }
  if (done.size() > 1) {
    const auto page = (out.empty() ? std::filesystem::path("out") : out) / "index.html";
    reports::write_index(done, page, "wetfront: " + std::to_string(done.size()) + " scenes");
    fmt::print("index of all runs -> {}\n", page.string());
  }
  return code;
}

}  // namespace wetfront::verification::commands
