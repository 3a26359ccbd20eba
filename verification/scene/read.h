#pragma once

#include "verification/scene/scene.h"
#include "verification/scene/set_value.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace wetfront::verification {

/// One or more complaints about a scene, each `file:line:column: problem (why). suggestion`.
struct SceneError : std::runtime_error {
  explicit SceneError(std::vector<std::string> messages);
  std::vector<std::string> messages;
};

/// Reads and cross-checks a scene, with values set anew where `settings` say so: the scene's text is then that of the
/// file with those values in it. Throws SceneError with every complaint found, in file order.
Scene read_scene(const std::filesystem::path& path, const std::vector<Setting>& settings = {});

/// The text of a scene file with values set anew. Throws SceneError where there is none, or a path leads nowhere.
std::string scene_file_text(const std::filesystem::path& path, const std::vector<Setting>& settings = {});

/// The JSON Schema (draft 2020-12) of a scene, generated from the table of keys that the reader itself uses.
std::string scene_schema();

/// The same table as a Markdown reference page: key, unit, default, meaning.
std::string scene_reference_page();

}  // namespace wetfront::verification
