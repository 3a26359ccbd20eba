#include "verification/commands/commands.h"
#include "verification/compare/verdict.h"
#include "verification/run/compare_foreign.h"
#include "verification/scene/read.h"

#include <fmt/format.h>

namespace wetfront::verification::commands {

int compare(const std::filesystem::path& path, const std::filesystem::path& declaration,
            const std::filesystem::path& out, const ReferenceStore& store) {
  const Scene scene = read_scene(path);
  const ForeignResult foreign = read_foreign(declaration);
  const auto folder = out.empty() ? std::filesystem::path("out") / ("compare_" + case_name(declaration)) : out;
  const RunResult result = compare_foreign(scene, foreign, folder, store);
  fmt::print("{} against the reference of {}: {} -> {}\n", foreign.code, case_name(path), word(result.record.verdict),
             (folder / "report.html").string());
  print_findings(result.record);
  return static_cast<int>(result.exit);
}

}  // namespace wetfront::verification::commands
