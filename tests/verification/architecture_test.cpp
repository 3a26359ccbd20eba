// Who may include whom (README, "The house"): a build that breaks an arrow fails here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
const fs::path root = WETFRONT_SOURCE_DIR;
const std::set<std::string> folders = {"meshes", "mpm", "fem_reference", "reports", "verification", "tests"};

/// The folders whose headers a folder may include beside its own.
const std::map<std::string, std::set<std::string>> allowed = {
    {"meshes", {}},
    {"mpm", {"meshes"}},
    {"fem_reference", {"meshes"}},
    {"reports", {}},
    {"verification", {"meshes", "mpm", "fem_reference", "reports"}},
};

std::vector<fs::path> sources(const std::string& folder, bool headers_only = false) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const auto extension = entry.path().extension();
    if (extension == ".h" || (!headers_only && extension == ".cpp")) found.push_back(entry.path());
  }
  return found;
}

std::vector<std::string> includes(const fs::path& file) {
  static const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<std::string> found;
  std::ifstream in(file);
  std::smatch match;
  for (std::string line; std::getline(in, line);)
    if (std::regex_search(line, match, include)) found.push_back(match[1]);
  return found;
}

std::string top(const std::string& include) {
  return include.substr(0, include.find('/'));
}

TEST(Architecture, IncludesFollowTheArrows) {
  for (const auto& [folder, may] : allowed)
    for (const fs::path& file : sources(folder))
      for (const std::string& include : includes(file)) {
        const std::string from = top(include);
        if (from == folder || !folders.contains(from) || include.find('/') == std::string::npos) continue;
        EXPECT_TRUE(may.contains(from)) << fs::relative(file, root) << " includes " << include;
      }
}

TEST(Architecture, PublicHeadersOfTheSolversAndReportsAreStdOnly) {
  for (const fs::path header : {"fem_reference/richards_problem.h", "reports/record.h", "reports/write.h",
                                "mpm/problem.h", "mpm/plan.h", "mpm/simulation.h"})
    for (const std::string& include : includes(root / header)) {
      const bool own = folders.contains(top(include)) && include.find('/') != std::string::npos;
      const bool standard = include.find('/') == std::string::npos && include.find(".h") == std::string::npos;
      EXPECT_TRUE(own || standard) << header << " includes " << include;
    }
}

TEST(Architecture, ForeignHeadersStayInTheirRooms) {
  const std::map<std::string, std::string> room = {{"deal.II", "fem_reference"}, {"sundials", "fem_reference"},
                                                   {"idas", "fem_reference"},    {"Eigen", "mpm"},
                                                   {"toml++", "verification"},   {"CLI", "verification"}};
  for (const std::string& folder : folders) {
    if (folder == "tests") continue;
    for (const fs::path& file : sources(folder))
      for (const std::string& include : includes(file)) {
        const auto found = room.find(top(include));
        EXPECT_TRUE(found == room.end() || found->second == folder)
            << fs::relative(file, root) << " includes " << include;
      }
  }
}

TEST(Architecture, NothingIncludesTests) {
  for (const auto& [folder, may] : allowed)
    for (const fs::path& file : sources(folder))
      for (const std::string& include : includes(file)) EXPECT_NE(top(include), "tests") << file;
}

TEST(Architecture, EveryFolderOpensWithAReadme) {
  for (const char* folder : {"meshes", "mpm", "fem_reference", "verification", "reports", "tests"})
    EXPECT_TRUE(fs::exists(root / folder / "README.md")) << folder;
}

}  // namespace
