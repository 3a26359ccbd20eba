#include "mpm/plan.h"
#include "verification/commands/commands.h"
#include "verification/present/plan_text.h"
#include "verification/run/run_scene.h"
#include "verification/scene/read.h"

#include <fmt/format.h>

namespace wetfront::verification::commands {

int explain(const Paths& scenes) {
  for (const auto& path : scenes) {
    const Prepared prepared = prepare(read_scene(path));
    if (scenes.size() > 1) fmt::print("{}\n", path.string());
    fmt::print("{}\n\n{}", prepared.scene.title, plan_text(mpm::plan(prepared.problem)));
    if (prepared.scene.reference)
      fmt::print(
          "reference: Richards finite elements on {} cells, tolerance {:g}, again on {} cells for its own error\n",
          prepared.scene.reference->cells, prepared.scene.reference->tolerance, 2 * prepared.scene.reference->cells);
    else
      fmt::print("reference: none, the scene asks for no comparison\n");
  }
  return 0;
}

}  // namespace wetfront::verification::commands
