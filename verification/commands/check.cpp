#include "mpm/plan.h"
#include "verification/commands/commands.h"
#include "verification/run/run_scene.h"
#include "verification/scene/read.h"

#include <fmt/format.h>

namespace wetfront::verification::commands {

int check(const Paths& scenes) {
  int code = 0;
  for (const auto& path : scenes) {
    try {
      mpm::plan(prepare(read_scene(path)).problem);
      fmt::print("{}: fine\n", path.string());
    } catch (const SceneError& error) {
      for (const std::string& message : error.messages) fmt::print(stderr, "{}\n", message);
      code = static_cast<int>(Exit::bad_input);
    }
  }
  return code;
}

}  // namespace wetfront::verification::commands
