#include "mpm/plan.h"
#include "verification/commands/commands.h"
#include "verification/present/plan_text.h"
#include "verification/run/run_scene.h"
#include "verification/scene/read.h"
#include "verification/study/effects.h"
#include "verification/translate/mpm_lacks.h"

#include <fmt/format.h>

namespace wetfront::verification::commands {

int explain(const Paths& scenes, const std::vector<Setting>& settings) {
  for (const auto& path : scenes) {
    const Scene scene = read_scene(path, settings);
    if (const auto lacking = mpm_lacks(scene); !lacking.empty()) {
      if (!scene.reference) throw SceneError(lacking);
      fmt::print("{}\n\nonly the reference can run this scene:\n", scene.title);
      for (const std::string& message : lacking) fmt::print("  {}\n", message);
      continue;
    }
    const Prepared prepared = prepare(scene);
    if (scenes.size() > 1) fmt::print("{}\n", path.string());
    fmt::print("{}\n\n{}", prepared.scene.title, plan_text(mpm::plan(prepared.problem)));
    if (prepared.scene.reference)
      fmt::print(
          "reference: Richards finite elements on {} cells, tolerance {:g}; for its own error also on cells twice and "
          "half as large and at tolerance {:g}\n",
          prepared.scene.reference->cells, prepared.scene.reference->tolerance,
          prepared.scene.reference->tolerance / 10);
    else
      fmt::print("reference: none, the scene asks for no comparison\n");
    const auto folder = std::filesystem::path("out") / ("study_effects_" + case_name(path));
    if (const auto sentences = stored_effects(scene, folder); !sentences.empty()) {
      fmt::print("\nwhat the scene needs, by the study of effects in {}:\n", folder.string());
      for (const std::string& sentence : sentences) fmt::print("  {}\n", sentence);
    }
  }
  return 0;
}

}  // namespace wetfront::verification::commands
