#pragma once

#include "mpm/coupling/strength_reduction.h"
#include "verification/run/run_scene.h"
#include "verification/scene/setting.h"

#include <filesystem>
#include <string>
#include <vector>

/// The commands of `wetfront`, one file each. All return an exit code of architecture: 0 pass, 1 a comparison failed,
/// 2 bad input, 3 a solver gave up, 4 inconclusive. Bad input is thrown and becomes 2 in main.
namespace wetfront::verification::commands {

using Paths = std::vector<std::filesystem::path>;

/// An error or tolerance as people write it: "0.083 %" or "0.0031 m".
std::string amount(double value, const std::string& unit);
/// A line for each finding that has a gate; why, where it did not pass.
void print_findings(const reports::Record& record);

/// How scenes are run.
struct RunRequest {
  RunOptions options;
  std::vector<std::string> settings;  ///< "rain.intensity=2e-5", for every scene
  std::string quantity;               ///< that the accuracy is meant of; empty: pressure_l2
  std::filesystem::path study;        ///< where a study of accuracy is kept; empty: out/study_accuracy_<scene>
};
int run(const Paths& scenes, const std::filesystem::path& out, const RunRequest& request);
/// With values of the scenes set anew (scene/set_value.h).
int explain(const Paths& scenes, const std::vector<Setting>& settings = {});
int check(const Paths& scenes, const std::vector<Setting>& settings = {});
int reference(const std::filesystem::path& scene, const std::filesystem::path& out, const ReferenceStore& store);
/// A result folder again from its result.json; of a folder that holds several, the page over all of them.
int report(const std::filesystem::path& folder);
/// Another code's stored result, declared in a file, against the reference of a scene.
int compare(const std::filesystem::path& scene, const std::filesystem::path& declaration,
            const std::filesystem::path& out, const ReferenceStore& store);
int new_scene(const std::string& name, bool slide);
int schema(bool as_page);
/// A suite of cases: one page per case, one index. `heavy`: also what takes long; `only`: cases whose name contains it
/// (empty: all). Throws std::invalid_argument for a suite that is not there.
int verify(const std::string& suite, const std::filesystem::path& out, bool heavy, const std::string& only);
std::vector<std::string> suite_names();

/// What the studies are asked for.
struct StudyRequest {
  std::filesystem::path scene, out;   ///< out: empty for out/study_<kind>_<scene>
  std::vector<std::string> settings;  ///< "rain.intensity=1e-5,2e-5"
  int jobs = 0;                       ///< points at a time; 0: one per processor
  bool list = false, gather = false;
  int point = -1;  ///< compute this one alone
  ReferenceStore store;
  std::vector<std::string> command;  ///< the program's own arguments, for its workers
};
/// Any scene value swept, several at once: every combination, side by side, resumed where it was interrupted.
int study_vary(const StudyRequest& request);
/// What accuracy costs: schemes, cells, tolerances, points per cell; `budget`: CPU seconds that one point may cost.
int study_accuracy(const StudyRequest& request, double budget);
/// Which effects matter: each left out or added in turn.
int study_effects(const StudyRequest& request, double budget);
/// The factor of safety over time, at these times [s] (empty: ten even parts), until the scene moves in true time.
int study_safety(const StudyRequest& request, const std::vector<double>& times, const mpm::SafetySearch& search);
/// A run with the ledger of differences.
int study_difference(const StudyRequest& request);

}  // namespace wetfront::verification::commands
