#pragma once

#include "verification/run/run_scene.h"

namespace wetfront::verification {

/// Solves a scene's reference alone, at its resolution and twice as fine, and reports the difference: the
/// reference's own error. The page stands in `folder`.
RunResult run_reference(const Scene& scene, const std::filesystem::path& folder);

}  // namespace wetfront::verification
