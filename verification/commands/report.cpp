#include "reports/junit.h"
#include "reports/write.h"
#include "verification/commands/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace wetfront::verification::commands {

namespace {

bool holds_result(const std::filesystem::path& folder) {
  return std::filesystem::exists(folder / "result.json");
}

std::vector<std::filesystem::path> runs_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> runs;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (holds_result(entry.path())) runs.push_back(entry.path());
  std::sort(runs.begin(), runs.end());
  return runs;
}

bool is_study(const std::filesystem::path& run) {
  return reports::read_result(run / "result.json").kind != reports::Record{}.kind;
}

/// The runs of a folder, its studies, then those of each folder in it: "verify_reference" becomes "verify reference".
std::vector<reports::RunGroup> groups_in(const std::filesystem::path& folder) {
  std::vector<reports::RunGroup> groups;
  auto runs = runs_in(folder);
  const auto studies = std::stable_partition(runs.begin(), runs.end(), std::not_fn(is_study));
  if (studies != runs.begin()) groups.push_back({"Comparisons", {runs.begin(), studies}});
  if (studies != runs.end()) groups.push_back({"Studies", {studies, runs.end()}});
  std::vector<std::filesystem::path> inner;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_directory() && !holds_result(entry.path())) inner.push_back(entry.path());
  std::sort(inner.begin(), inner.end());
  for (const auto& suite : inner) {
    std::string title = suite.filename().string();
    std::replace(title.begin(), title.end(), '_', ' ');
    if (const auto cases = runs_in(suite); !cases.empty()) groups.push_back({title, cases});
  }
  return groups;
}

}  // namespace

int report(const std::filesystem::path& folder) {
  if (std::filesystem::is_directory(folder) && !holds_result(folder)) {
    const auto groups = groups_in(folder);
    if (groups.empty())
      throw std::invalid_argument(folder.string() +
                                  ": no result.json in it or one or two folders below (nothing ran there). Name the "
                                  "output folder of a run, or one that holds several");
    reports::write_index(groups, folder / "index.html", "wetfront: all that is in " + folder.filename().string());
    reports::write_junit(groups, folder / "junit.xml");
    fmt::print("{}\n", (folder / "index.html").string());
    return 0;
  }
  reports::render_again(folder);
  fmt::print("{}\n", (folder / "report.html").string());
  return 0;
}

}  // namespace wetfront::verification::commands
