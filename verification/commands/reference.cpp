#include "reports/write.h"
#include "verification/commands/commands.h"
#include "verification/run/run_reference.h"
#include "verification/scene/read.h"

#include <fmt/format.h>

#include <stdexcept>

namespace wetfront::verification::commands {

int reference(const std::filesystem::path& path, const std::filesystem::path& out, const ReferenceStore& store) {
  const Scene scene = read_scene(path);
  if (!scene.reference)
    throw std::invalid_argument(path.string() + ":1:1: the scene has no reference (no [reference] section). Add one");
  const auto folder = out.empty() ? std::filesystem::path("out") / (case_name(path) + "_reference") : out;
  const ReferenceResult result = run_reference(scene, folder, store);
  fmt::print("reference of {}: {:.2f} CPU-s -> {}\n", case_name(path), result.record.cpu_seconds,
             (folder / "report.html").string());
  for (const auto& finding : result.record.findings) fmt::print("  {}: {:.3g}\n", finding.description, finding.error);
  for (const auto& [name, solved] : result.runs.all())
    if (!solved->gave_up.empty()) fmt::print(stderr, "  {} gave up: {}\n", name, solved->gave_up);
  return static_cast<int>(result.exit);
}

}  // namespace wetfront::verification::commands
