#pragma once

#include "verification/scene/setting.h"

#include <string>

/// One value of a scene set anew, in the text of the file: comments, order and line numbers stay.
namespace wetfront::verification {

/// `text` with the value in place of the one it has, or with a key or section it lacks. Whether the value makes sense
/// is the reader's to say. Throws SceneError naming `--set PATH` where the path leads nowhere, with what there is
/// instead.
std::string with_value(const std::string& text, const std::string& file, const Setting& setting);

/// The unit of the value at a path as the scene writes it; "" for none. Throws as with_value.
std::string written_unit(const std::string& text, const std::string& path);

}  // namespace wetfront::verification
