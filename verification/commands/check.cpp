#include "mpm/plan.h"
#include "verification/commands/commands.h"
#include "verification/run/run_scene.h"
#include "verification/scene/read.h"
#include "verification/translate/initial_pressure.h"
#include "verification/translate/mpm_lacks.h"
#include "verification/translate/scene_mesh.h"
#include "verification/translate/to_reference.h"

#include <fmt/format.h>

namespace wetfront::verification::commands {
namespace {

/// Translates the scene for the solvers that it is for; says for which, and why not for both.
std::string checked(Scene scene) {
  if (start_is_computed(scene)) scene.initial->pressure = UniformStart{0};  // computing it is not checking
  const std::vector<std::string> lacking = mpm_lacks(scene);
  if (lacking.empty()) {
    mpm::plan(prepare(scene).problem);
    return "fine";
  }
  if (!scene.reference) throw SceneError(lacking);
  const auto problem = to_reference(scene, timeline(scene), {scene.reference->cells, 0, scene.reference->tolerance});
  for (const Boundary& boundary : scene.boundaries)
    if (problem.mesh.dim > 1) problem.mesh.side(boundary.side);
  std::string text = "fine for `wetfront reference`; `wetfront run` would say:";
  for (const std::string& message : lacking) text += "\n  " + message;
  return text;
}

}  // namespace

int check(const Paths& scenes, const std::vector<Setting>& settings) {
  int code = 0;
  for (const auto& path : scenes) {
    try {
      fmt::print("{}: {}\n", path.string(), checked(read_scene(path, settings)));
    } catch (const SceneError& error) {
      for (const std::string& message : error.messages) fmt::print(stderr, "{}\n", message);
      code = static_cast<int>(Exit::bad_input);
    }
  }
  return code;
}

}  // namespace wetfront::verification::commands
