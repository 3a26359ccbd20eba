#pragma once

#include "verification/run/run_scene.h"

#include <filesystem>
#include <string>
#include <vector>

/// The commands of `wetfront`, one file each. All return an exit code of architecture: 0 pass, 1 a comparison failed,
/// 2 bad input, 3 a solver gave up, 4 inconclusive. Bad input is thrown and becomes 2 in main.
namespace wetfront::verification::commands {

using Paths = std::vector<std::filesystem::path>;

int run(const Paths& scenes, const std::filesystem::path& out, const RunOptions& options);
int explain(const Paths& scenes);
int check(const Paths& scenes);
int reference(const std::filesystem::path& scene, const std::filesystem::path& out, const ReferenceStore& store);
/// A result folder again from its result.json; of a folder that holds several, the page over all of them.
int report(const std::filesystem::path& folder);
int new_scene(const std::string& name);
int schema(bool as_page);
/// A suite of cases: one page per case, one index. `heavy`: also what takes long; `only`: cases whose name contains it
/// (empty: all). Throws std::invalid_argument for a suite that is not there.
int verify(const std::string& suite, const std::filesystem::path& out, bool heavy, const std::string& only);
std::vector<std::string> suite_names();

}  // namespace wetfront::verification::commands
